// SPDX-License-Identifier: BSD-3-Clause
// Clouds of points as text: a point a line, blanks, commas or semicolons between its numbers.
#ifndef WideFoVCloudFile_h
#define WideFoVCloudFile_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace widefov
{
// The points, with an array for each further column. A first line of words names the columns; x, y
// and z are the first three without it. Columns named r, g, b or red, green, blue, and the last
// three of six or seven whole numbers from 0 to 255, are colours (RGB). A first line with one
// number is a count. Throws std::runtime_error, which names the line.
vtkSmartPointer<vtkPolyData> ReadCloud(const std::string& path);
}

#endif
