// SPDX-License-Identifier: BSD-3-Clause
// How far a drawn picture is from the ray caster's: the metrics of the benchmark.
#ifndef WideFoVMetrics_h
#define WideFoVMetrics_h

#include "vtkWideFoVAbi.h"

#include "RayCaster.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace reference
{
// What was drawn, rows from the top.
struct DrawnPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Cell;     // 0 for nothing, else 1 + the cell id
  std::vector<float> Distance; // eye to surface along the ray, scene units; +inf for nothing
};

// From the output of vtkWideFoVDataPass (its arrays "cell" and "distance", rows from the
// bottom). Empty where an array is missing.
DrawnPicture ToDrawnPicture(vtkImageData* image);

// The same of a scene of several props, whose cells are numbered through: those of the
// prop with index i (vtkWideFoVDataPass::SetPropIndex) from firstCells[i] on.
DrawnPicture ToDrawnPicture(vtkImageData* image, const std::vector<vtkIdType>& firstCells);

// A pixel that shows another cell than the reference does.
struct WorstPixel
{
  int I = 0;
  int J = 0;                // from the top
  vtkIdType Drawn = -1;     // cell id, -1 for nothing
  vtkIdType Reference = -1; // at the pixel centre
  double DrawnDistance = 0;
  double ReferenceDistance = 0;
  double Pixels = 0;      // to the nearest place found where the reference agrees, may be inf
  bool Tie = false;       // right as well: a ray turned by nothing sees it, RightAnswers.h
  bool Explained = false; // by one of the 48 points, or so
};

struct Metrics
{
  double Unexplained = 0; // fractions of all pixels of the picture
  double Missing = 0;     // part of it: the reference hits, nothing was drawn
  double Spurious = 0;    // part of it: something was drawn, the reference hits nothing
  double MaxPx = 0;       // pixels; over the mismatched pixels, 0 if there are none
  double P99Px = 0;
  double MaxDepthRel = 0; // relative difference of the distances where the cells agree
  double DepthPx = 0;     // pixels: where that is more than DepthRel, what shift explains it
  double DepthUlps = 0;   // there: the difference over what float32 makes of the ray alone
  long Mismatched = 0;    // pixels whose cells differ at the pixel centre
  long Searched = 0;      // of them, those that were searched for a place of agreement
  long UnexplainedPixels = 0;
  long Ties = 0;                 // of them all, explained by RightAnswers.h alone
  long DomainPixels = 0;         // pixels whose centre lies in the domain of the map
  std::vector<WorstPixel> Worst; // unexplained, farthest first, at most MaxWorst
  static constexpr std::size_t MaxWorst = 64;
};

// Relative: what a distance may be off wherever a surface is not seen edge-on.
constexpr double DepthRel = 1e-5;

// Pixels: a pixel that shows what the reference sees nowhere so near has the distance inf.
constexpr double SearchLimit = 64;

// `tolerance` is b in pixels: a mismatched pixel is explained if the reference agrees at
// one of 48 points, 16 on each of the circles of radius b, b/2 and b/4 round its centre.
Metrics Compare(const DrawnPicture& drawn, const Caster& caster, double tolerance);

// The same with the ray caster's own picture at hand (of the drawn one's size).
// Of more than `mostSearched` mismatched pixels only so many, taken evenly, are searched:
// what is counted then is an estimate, and MaxPx no more than the true one.
Metrics Compare(const DrawnPicture& drawn, const Caster& caster, const HitPicture& reference,
  double tolerance, std::size_t mostSearched = std::numeric_limits<std::size_t>::max());

// Whether the reference agrees with what was drawn at this pixel at one of those 48 points.
bool IsExplained(
  const Caster& caster, int width, int height, const WorstPixel& pixel, double tolerance);

// The 48 points step over cells thinner than a quarter of b; but what is explained within a
// smaller b is explained within b. The least of the radii b, b/2, .. b/64 at which one of
// 16 points of its circle agrees with what was drawn at this pixel; inf where none does.
double NearestAgreement(
  const Caster& caster, int width, int height, const WorstPixel& pixel, double radius);
}
}

#endif
