// SPDX-License-Identifier: BSD-3-Clause
// What the header of a classic netCDF file promises.
#ifndef WideFoVNetCdfHeader_h
#define WideFoVNetCdfHeader_h

#include <string>

namespace widefov
{
// Damage that the netCDF library lets through: it fills with zeros what lies behind the
// end of a file that was cut off. An empty string, or what is wrong. Files in other
// formats (HDF5, which checks itself) give an empty string.
std::string DamagedNetCdf(const std::string& path);
}

#endif
