// SPDX-License-Identifier: BSD-3-Clause
// What the OpenGL that is current can, and where a driver needs to be drawn with in another way.
#ifndef WideFoVDriver_h
#define WideFoVDriver_h

namespace wfv
{
bool HasExtension(const char* name);

// Mesa's software renderers (seen with 22.3) number the pieces of one tessellated draw with 16
// bits, and the patches of one draw anew every 1,024 indices: they need small draws.
bool NeedsSmallPatchDraws();
}

#endif
