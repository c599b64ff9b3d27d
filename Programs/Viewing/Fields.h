// SPDX-License-Identifier: BSD-3-Clause
// The fields of view under zoom, in other projections and windows of other shapes.
#ifndef WideFoVFields_h
#define WideFoVFields_h

#include "Options/Options.h"

namespace widefov
{
// What the user asked for is kept beside what a projection can show of it, so that going
// through the projections, or zooming out and in again, changes nothing.
class Fields
{
public:
  // Complete options: their projection, fields of view and size.
  explicit Fields(const Options& options);

  // Narrows (factor below 1) or widens the view: angles in proportion, in the perspective
  // the picture. False where the projection always shows the same.
  bool Zoom(const Options& options, double factor);

  // Sets the fields of view for the projection and the size that the options name, and the lens
  // and its place where the projection is the one that they were given for.
  void Apply(Options& options) const;

private:
  struct Angles
  {
    double Horizontal;
    double Vertical;
  };
  Angles PlanarAngles(const Options& options) const;
  double LargestZoom(const Options& options) const;

  Angles Wide{ 360, 180 };
  double WideZoom = 1;
  wfv::LensCoefficients Lens;
  wfv::MeasuredPicture Measured;
  std::string Lensed;          // the projection that has them
  double PlanarWidth = 1;      // of the perspective's picture at distance 1, over 2
  double PlanarProportion = 1; // of a pixel, height over width, as seen
};
}

#endif
