// SPDX-License-Identifier: BSD-3-Clause
// Where the pictures of the two eyes go.
#ifndef WideFoVStereoLayout_h
#define WideFoVStereoLayout_h

#include <string>
#include <vector>

namespace widefov
{
// One way of showing two eyes.
struct StereoLayout
{
  std::string Name;       // as on the command line
  std::vector<int> Types; // VTK's stereo types to draw with, one after the other
  int Columns = 1;        // eyes side by side in the picture
  int Rows = 1;           // eyes one above the other, the left on top
  bool Half = false;      // squeezed into a picture of one eye's size
  bool Separate = false;  // a file for each eye
  bool MultiView = false; // one file that keeps the eyes apart
  bool Vr180 = false;     // half a sphere an eye
  bool InTurn = false;    // a window's alone: one eye after the other

  // The picture shows what one eye sees, as it sees it.
  bool IsOneEye() const
  {
    return this->Separate || this->MultiView || this->Name == "left" || this->Name == "right";
  }

  // How readers of panoramas call two pictures of full size in one; empty: no such layout.
  std::string SphericalMode() const
  {
    const bool two = this->Columns * this->Rows == 2 && !this->Half;
    return !two ? "" : (this->Columns == 2 ? "left-right" : "top-bottom");
  }
};

std::vector<std::string> StereoLayoutNames();

// The layout of that name; it must be one of them.
const StereoLayout& FindStereoLayout(const std::string& name);

// Name of the file of picture number i: picture-left.png, picture-right.png where each eye has
// its own.
std::string FileOfEye(const StereoLayout& layout, const std::string& path, std::size_t i);
}

#endif
