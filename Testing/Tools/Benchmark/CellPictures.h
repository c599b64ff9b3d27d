// SPDX-License-Identifier: BSD-3-Clause
// Which cell each pixel of a run shows.
#ifndef WideFoVCellPictures_h
#define WideFoVCellPictures_h

#include "vtkWideFoVAbi.h"

#include "Metrics.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkWideFoVDataPass.h>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderPass;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace bench
{
struct BenchEntry;
struct BenchScene;

// While one of these lives, the entry is drawn at pixel centres into `cell` and
// `distance` instead of into the window.
class DataPicture
{
public:
  explicit DataPicture(BenchEntry& entry);
  ~DataPicture();
  DataPicture(const DataPicture&) = delete;
  DataPicture& operator=(const DataPicture&) = delete;

  // The entry's renderer must be on.
  reference::DrawnPicture Draw(const std::vector<vtkIdType>& firstCells);

private:
  BenchEntry& Entry;
  vtkNew<vtkWideFoVDataPass> Data;
  vtkSmartPointer<vtkRenderPass> Before;
};

long CountCovered(const reference::DrawnPicture& picture);

// What the cubemap shows, as cells: its faces are drawn with 1 + the cell's number as an
// exact colour of 24 bits (no light, no multisampling), and its projection takes the
// nearest texel instead of a blend of four. Distances are 0: it has none.
reference::DrawnPicture DrawCubeMapCells(const BenchEntry& entry, const BenchScene& scene);
}
}

#endif
