// SPDX-License-Identifier: BSD-3-Clause
// What VTK makes in the place of its own classes once this library is loaded: actors and texts that
// find the wide frame in which another prop draws them, and mappers that classify the clusters of
// their meshes. In any other view they are what they stand for, to the pixel.
#ifndef WideFoVOverrides_h
#define WideFoVOverrides_h

namespace wfv
{
// Loading the library registers them; to call this again does nothing where they still are.
void RegisterOverrides();
}

#endif
