// SPDX-License-Identifier: BSD-3-Clause
#include "FileProxy.h"

#include <cerrno>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace widefov
{
FileProxy::FileProxy(int file, std::size_t insertAt, std::vector<unsigned char> insert)
  : IOProxy("picture", Write)
  , File(file)
  , InsertAt(insertAt)
  , Insert(std::move(insert))
{
}

size_t FileProxy::read(void* buffer, size_t size)
{
  const size_t n = this->pread(buffer, size, this->m_pos);
  this->m_pos += static_cast<int64_t>(n);
  return n;
}

size_t FileProxy::pread(void* buffer, size_t size, int64_t offset)
{
  const ssize_t n = ::pread(this->File, buffer, size, offset);
  return n < 0 ? 0 : static_cast<size_t>(n);
}

size_t FileProxy::write(const void* buffer, size_t size)
{
  const auto* const bytes = static_cast<const char*>(buffer);
  const auto at = static_cast<std::size_t>(this->m_pos);
  const bool crosses = !this->Insert.empty() && at + size >= this->InsertAt;
  const std::size_t first = crosses ? this->InsertAt - at : size;
  size_t done = this->pwrite(bytes, first, this->m_pos);
  this->m_pos += static_cast<int64_t>(done);
  if (crosses)
  {
    const std::vector<unsigned char> insert = std::move(this->Insert);
    this->Insert.clear();
    this->m_pos += static_cast<int64_t>(this->pwrite(insert.data(), insert.size(), this->m_pos));
    const std::size_t rest = this->pwrite(bytes + first, size - first, this->m_pos);
    this->m_pos += static_cast<int64_t>(rest);
    done += rest;
  }
  return done;
}

size_t FileProxy::pwrite(const void* buffer, size_t size, int64_t offset)
{
  const auto* bytes = static_cast<const char*>(buffer);
  size_t done = 0;
  while (done < size)
  {
    const ssize_t n =
      ::pwrite(this->File, bytes + done, size - done, offset + static_cast<int64_t>(done));
    if (n < 0 && errno == EINTR)
    {
      continue;
    }
    if (n <= 0)
    {
      this->Error = this->Error != 0 ? this->Error : n < 0 ? errno : ENOSPC;
      return done;
    }
    done += static_cast<size_t>(n);
  }
  return done;
}

size_t FileProxy::size() const
{
  struct stat status = {};
  return fstat(this->File, &status) == 0 ? static_cast<size_t>(status.st_size) : 0;
}
}
