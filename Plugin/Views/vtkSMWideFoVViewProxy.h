// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMWideFoVViewProxy
 * @brief   the server manager's proxy of a vtkPVWideFoVView
 *
 * A vtkSMRenderViewProxy whose camera on the client is a vtkWideFoVCamera.
 */
#ifndef vtkSMWideFoVViewProxy_h
#define vtkSMWideFoVViewProxy_h

#include "vtkSMRenderViewProxy.h"
#include "vtkWideFoVPluginViewsModule.h" // For export macro

class VTKWIDEFOVPLUGINVIEWS_EXPORT vtkSMWideFoVViewProxy : public vtkSMRenderViewProxy
{
public:
  static vtkSMWideFoVViewProxy* New();
  vtkTypeMacro(vtkSMWideFoVViewProxy, vtkSMRenderViewProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMWideFoVViewProxy() = default;
  ~vtkSMWideFoVViewProxy() override = default;
  void CreateVTKObjects() override;

private:
  vtkSMWideFoVViewProxy(const vtkSMWideFoVViewProxy&) = delete;
  void operator=(const vtkSMWideFoVViewProxy&) = delete;
};

#endif
