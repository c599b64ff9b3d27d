// SPDX-License-Identifier: BSD-3-Clause
// Files of settings, some hundred bytes long: all of the text, or one line that says why not.
#ifndef WideFoVSmallFile_h
#define WideFoVSmallFile_h

#include <string>

namespace widefov
{
// The text of a file of at most 1 MiB. `advice` ends the message where there is none, such as
// "give a screens file as ParaView's .pvx". Throws a Failure with ExitFailed.
std::string ReadSmallFile(const std::string& path, const std::string& advice);
}

#endif
