// SPDX-License-Identifier: BSD-3-Clause
// Files, by their ending, as VTK data.
#ifndef WideFoVReaders_h
#define WideFoVReaders_h

#include "Scene.h"

#include <optional>
#include <string>
#include <vector>

namespace widefov
{
// What a file holds. Throws a Failure with ExitFailed where the file is missing, not a
// regular file, empty, of an unknown ending, or damaged. time: of the step that is read, of a file
// that has several.
vtkSmartPointer<vtkDataObject> ReadFile(
  const std::string& path, const std::optional<double>& time = std::nullopt);

// The times of all steps that the file has, of data that ReadFile made; none where it has none.
std::vector<double> TimesOf(vtkDataObject* data);

// The props of data that ReadFile made: one, or of composite data one for each set of arrays that
// its parts have.
std::vector<SceneProp> PropsOf(vtkDataObject* data);

// One prop a file, of glTF and composite data one a part, in the order given. Cells with unusable
// points are left out with a warning; a file of which nothing is left throws a Failure with
// ExitFailed.
Scene ReadScene(
  const std::vector<std::string>& paths, const std::optional<double>& time = std::nullopt);

// Leaves out cells with unusable points, with a warning; throws a Failure with
// ExitFailed where nothing is left.
void DropUnusable(SceneProp& prop);
}

#endif
