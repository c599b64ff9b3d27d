// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVOverrides
 * @brief   while one lives, vtkRenderer::New and vtkCamera::New give the wide classes
 *
 * vtkPVRenderView makes its renderers, and the server manager the camera, by those calls
 * and keeps them; there is no later moment at which all that hangs on them could be
 * changed. Scopes may be nested. Main thread only, as the views are.
 */
#ifndef vtkWideFoVOverrides_h
#define vtkWideFoVOverrides_h

class vtkWideFoVOverrides
{
public:
  vtkWideFoVOverrides();
  ~vtkWideFoVOverrides();
  vtkWideFoVOverrides(const vtkWideFoVOverrides&) = delete;
  void operator=(const vtkWideFoVOverrides&) = delete;
};

#endif
