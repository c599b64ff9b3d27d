// SPDX-License-Identifier: BSD-3-Clause
// Up to VTK 9.2: the helpers stand in a table of the mapper, where others are put before it draws.
#include "Frame/BlockClusters.h"

#include "Drawables/Kinds/DrawableKinds.h"
#include "Frame/vtkWideFoVCompositeHelper.h"

#include "vtkCompositePolyDataMapper2.h"
#include "vtkDataObject.h"

#include <array>
#include <string>

namespace
{
// The names under which a composite mapper looks for the helpers of blocks with or without
// scalars (A), normals (B) and texture coordinates (C). Helpers that it does not ask for it drops.
std::array<std::string, 8> NamesOfKinds()
{
  std::array<std::string, 8> names;
  for (std::size_t i = 0; i < names.size(); i++)
  {
    const auto digit = [i](int bit) { return std::to_string((i >> bit) & 1); };
    names[i] = "A" + digit(0) + "B" + digit(1) + "C" + digit(2);
  }
  return names;
}

// What a composite mapper keeps to itself.
class MapperAccess : public vtkCompositePolyDataMapper2
{
public:
  static void Give(vtkCompositePolyDataMapper2* mapper, vtkWindow* window)
  {
    auto& helpers = mapper->*(&MapperAccess::Helpers);
    vtkTimeStamp& time = mapper->*(&MapperAccess::HelperMTime);
    for (auto& entry : helpers)
    {
      if (wfv::HasTrait(entry.second, wfv::DrawsBlocks) &&
        !wfv::HasTrait(entry.second, wfv::ClassifiesBlocks))
      {
        entry.second->ReleaseGraphicsResources(window);
        entry.second->Delete();
        entry.second = NewFor(mapper);
        time = vtkTimeStamp(); // so that the blocks are handed out anew
      }
    }
    vtkDataObject* const input = mapper->GetInputDataObject(0, 0);
    if (!input || (time > input->GetMTime() && time > mapper->GetMTime()))
    {
      return;
    }
    static const std::array<std::string, 8> names = NamesOfKinds();
    for (const std::string& name : names)
    {
      vtkCompositeMapperHelper2*& helper = helpers[name];
      helper = helper ? helper : NewFor(mapper);
    }
  }

private:
  static vtkCompositeMapperHelper2* NewFor(vtkCompositePolyDataMapper2* mapper)
  {
    auto* const helper = vtkWideFoVCompositeHelper::New();
    helper->SetParent(mapper);
    return helper;
  }
};
}

// Any other mapper, or one that makes helpers of a kind of its own, is left as it is.
void wfv::ClassifyBlocksOf(vtkMapper* mapper, vtkWindow* window)
{
  // a class derived from it may make helpers of its own
  if (wfv::HasTrait(mapper, wfv::StockComposite))
  {
    MapperAccess::Give(static_cast<vtkCompositePolyDataMapper2*>(mapper), window);
  }
}

vtkObject* wfv::MakeBlockDelegator()
{
  return nullptr; // this VTK knows no delegators
}
