// SPDX-License-Identifier: BSD-3-Clause
// An overlay as a texture.
#ifndef WideFoVOverlayPicture_h
#define WideFoVOverlayPicture_h

#include "vtkWideFoVAbi.h"

#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkProp;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// What the overlay shows in a window of so many pixels: its colours, and how much of each pixel it
// covers. Where it covers nothing there are the colours of what is beside, for filters of textures
// mix them in.
vtkSmartPointer<vtkImageData> MakeOverlayPicture(vtkProp* overlay, int width, int height);
}

#endif
