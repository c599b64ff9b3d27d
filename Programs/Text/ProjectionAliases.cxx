// SPDX-License-Identifier: BSD-3-Clause
// Without the registry: what libraries in programs of others use too.
#include "ProjectionNames.h"

namespace widefov
{
const std::vector<Alias>& ProjectionAliases()
{
  static const std::vector<Alias> all{
    { "equidistant", "azimuthal-equidistant" },
    { "f-theta", "azimuthal-equidistant" },
    { "fisheye", "azimuthal-equidistant" },
    { "domemaster", "azimuthal-equidistant" },
    { "dome", "azimuthal-equidistant" },
    { "postel", "azimuthal-equidistant" },
    { "equisolid", "azimuthal-equal-area" },
    { "equisolid-angle", "azimuthal-equal-area" },
    { "lambert-azimuthal", "azimuthal-equal-area" },
    { "little-planet", "stereographic" },
    { "sg", "stereographic" },
    { "og", "orthographic" },
    { "rectilinear", "perspective" },
    { "pinhole", "perspective" },
    { "flat", "perspective" },
    { "equirect", "equirectangular" },
    { "plate-carree", "equirectangular" },
    { "latlong", "equirectangular" },
    { "lat-long", "equirectangular" },
    { "spherical", "equirectangular" },
    { "360", "equirectangular" },
    { "lambert-cylindrical", "cylindrical-equal-area" },
    { "cylindricalea", "cylindrical-equal-area" },
    { "cylindrical", "central-cylindrical" },
    { "web-mercator", "mercator" },
    { "pannini", "panini" },
    { "homolographic", "mollweide" },
    { "sanson-flamsteed", "sinusoidal" },
    { "winkel-3", "winkel-tripel" },
    { "eac", "equi-angular-cubemap" },
  };
  return all;
}
}
