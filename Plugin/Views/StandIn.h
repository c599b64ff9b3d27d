// SPDX-License-Identifier: BSD-3-Clause
// What draws a prop of ParaView's right in a wide view, in its place, for the time of a frame.
#ifndef WideFoVPluginStandIn_h
#define WideFoVPluginStandIn_h

class vtkProp;
class vtkRenderer;

namespace wfvplugin
{
class StandIn
{
public:
  virtual ~StandIn() = default;

  virtual vtkProp* GetStock() const = 0; // not owned: it may go

  // Shows, as the stock prop is now, from where the renderer's camera is, and hides the stock one;
  // and the other way round.
  virtual void Show(vtkRenderer* renderer) = 0;
  virtual void Hide() = 0;
};
}

#endif
