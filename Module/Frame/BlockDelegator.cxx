// SPDX-License-Identifier: BSD-3-Clause
// From VTK 9.3 on: a factory makes the delegators that composite mappers hand their blocks to.
#include "Frame/BlockClusters.h"

#include "Frame/vtkWideFoVCompositeHelper.h"

#include "vtkOpenGLCompositePolyDataMapperDelegator.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"

namespace
{
// Without a name of its own: whoever asks sees the class that it stands for.
class BlockDelegator : public vtkOpenGLCompositePolyDataMapperDelegator
{
public:
  static BlockDelegator* New()
  {
    auto* const made = new BlockDelegator;
    made->InitializeObjectBase();
    return made;
  }

protected:
  BlockDelegator()
  {
    this->GLDelegate = vtkWideFoVCompositeHelper::New();
    this->Delegate.TakeReference(this->GLDelegate);
  }

  vtkObjectBase* NewInstanceInternal() const override { return BlockDelegator::New(); }
};
}

void wfv::ClassifyBlocksOf(vtkMapper*, vtkWindow*) {}

vtkObject* wfv::MakeBlockDelegator()
{
  return BlockDelegator::New();
}
