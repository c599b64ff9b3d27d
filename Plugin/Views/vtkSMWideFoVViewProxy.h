// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMWideFoVViewProxy
 * @brief   the server manager's proxy of a vtkPVWideFoVView
 *
 * A vtkSMRenderViewProxy whose camera on the client is a vtkWideFoVCamera. There is none, and an
 * error that says why, while the client is connected to a server with another version of the
 * plugin.
 */
#ifndef vtkSMWideFoVViewProxy_h
#define vtkSMWideFoVViewProxy_h

#include "vtkSMRenderViewProxy.h"
#include "vtkWideFoVPluginViewsModule.h" // For export macro

class VTKWIDEFOVPLUGINVIEWS_EXPORT vtkSMWideFoVViewProxy : public vtkSMRenderViewProxy
{
public:
  /**
   * Null where client and server have different versions of the plugin.
   */
  static vtkSMWideFoVViewProxy* New();
  vtkTypeMacro(vtkSMWideFoVViewProxy, vtkSMRenderViewProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMWideFoVViewProxy() = default;
  ~vtkSMWideFoVViewProxy() override = default;
  void CreateVTKObjects() override;

  /**
   * A picture in tiles leaves the server's windows as they were.
   */
  vtkImageData* CaptureWindowInternal(int magX, int magY) override;

private:
  vtkSMWideFoVViewProxy(const vtkSMWideFoVViewProxy&) = delete;
  void operator=(const vtkSMWideFoVViewProxy&) = delete;
};

#endif
