// SPDX-License-Identifier: BSD-3-Clause
// A file as OpenImageIO writes to it, which remembers why it could not.
#ifndef WideFoVFileProxy_h
#define WideFoVFileProxy_h

#include <OpenImageIO/filesystem.h>

#include <vector>

namespace widefov
{
class FileProxy : public OIIO::Filesystem::IOProxy
{
public:
  // An open file, which stays its owner's. `insert` goes in where so many bytes are written, in
  // files that are written from the beginning to the end.
  FileProxy(int file, std::size_t insertAt, std::vector<unsigned char> insert);

  const char* proxytype() const override { return "widefov"; }
  size_t read(void* buffer, size_t size) override;
  size_t pread(void* buffer, size_t size, int64_t offset) override;
  size_t write(const void* buffer, size_t size) override;
  size_t pwrite(const void* buffer, size_t size, int64_t offset) override;
  size_t size() const override;

  // The errno of the first failure, or 0.
  int GetError() const { return this->Error; }

private:
  int File;
  int Error = 0;
  std::size_t InsertAt;
  std::vector<unsigned char> Insert;
};
}

#endif
