// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVEverywhereProp
 * @brief   draws nothing and is everywhere
 *
 * IceT crops each rank's picture to where a linear projection would show the bounds of
 * the visible props. With this prop among them the bounds hold the eye and reach farther
 * than any view, so that nothing is cropped. UseBounds is off until a frame is drawn:
 * nothing else may take these bounds for the scene's.
 */
#ifndef vtkWideFoVEverywhereProp_h
#define vtkWideFoVEverywhereProp_h

#include "vtkProp.h"

class vtkWideFoVEverywhereProp : public vtkProp
{
public:
  static vtkWideFoVEverywhereProp* New();
  vtkTypeMacro(vtkWideFoVEverywhereProp, vtkProp);
  double* GetBounds() override;

protected:
  vtkWideFoVEverywhereProp();
  ~vtkWideFoVEverywhereProp() override = default;

private:
  vtkWideFoVEverywhereProp(const vtkWideFoVEverywhereProp&) = delete;
  void operator=(const vtkWideFoVEverywhereProp&) = delete;

  double Bounds[6];
};

#endif
