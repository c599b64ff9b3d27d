// SPDX-License-Identifier: BSD-3-Clause
// Threads for what a frame computes on the CPU.
#ifndef WideFoVPluginFrameThreads_h
#define WideFoVPluginFrameThreads_h

#include <string>

namespace wfvplugin
{
// Whether this process draws alone.
bool HasOneRank();

// VTK shares loops out to threads by a backend that the whole process has, and ParaView's is often
// the sequential one. Clusters of triangles are classified before they are drawn, while the threads
// of software rendering wait, so from Begin to End it is VTK's own threads; then whatever it was.
// Several ranks have the cores to themselves already, and a backend that the user has chosen stays:
// by VTK's environment variable VTK_SMP_BACKEND_IN_USE.
class FrameThreads
{
public:
  void Begin();
  void End();

private:
  std::string Before; // empty where nothing was changed
};
}

#endif
