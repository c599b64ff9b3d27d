// SPDX-License-Identifier: BSD-3-Clause
// Image slices that are resampled to the pixels of the window, and stacks of images. They belong to
// a module of VTK that is not everywhere, and that this one does not need.
#ifndef WideFoVImageModule_h
#define WideFoVImageModule_h

#include "vtkImageMapper3D.h"
#include "vtkPropCollection.h"

#if __has_include("vtkImageResliceMapper.h") && __has_include("vtkImageStack.h")
#include "vtkImageResliceMapper.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceCollection.h"
#include "vtkImageStack.h"
#define WIDEFOV_HAS_IMAGE_MODULE 1
#endif

namespace wfv
{
#ifdef WIDEFOV_HAS_IMAGE_MODULE
class ResliceAccess : public vtkImageResliceMapper
{
public:
  static vtkTypeBool& Resamples(vtkImageResliceMapper* mapper)
  {
    return mapper->*(&ResliceAccess::ResampleToScreenPixels);
  }
};

// Whether it did before, of one that can; it does not count as modified.
inline bool SetResamplesToPixels(vtkImageMapper3D* mapper, bool resamples)
{
  if (!mapper->IsA("vtkImageResliceMapper"))
  {
    return false;
  }
  vtkTypeBool& flag = ResliceAccess::Resamples(static_cast<vtkImageResliceMapper*>(mapper));
  const bool before = flag != 0;
  flag = resamples;
  return before;
}

// All of its images, where the prop is a stack: by its path it names the active one alone.
inline void AddImagesOfStack(vtkProp* prop, vtkPropCollection* props)
{
  vtkImageSliceCollection* const images =
    prop->IsA("vtkImageStack") ? static_cast<vtkImageStack*>(prop)->GetImages() : nullptr;
  for (int i = 0; images && i < images->GetNumberOfItems(); i++)
  {
    props->AddItem(vtkProp::SafeDownCast(images->GetItemAsObject(i)));
  }
}
#else
inline bool SetResamplesToPixels(vtkImageMapper3D*, bool)
{
  return false;
}

inline void AddImagesOfStack(vtkProp*, vtkPropCollection*) {}
#endif
}

#endif
