// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that are the same on every machine: the standard leaves its
// distributions to the library, but not the engine.
#ifndef WideFoVStressRandom_h
#define WideFoVStressRandom_h

#include "Projections/ProjectionMath.h"

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace wfv
{
namespace stress
{
class Random
{
public:
  // Another text is another stream of the same seed.
  Random(std::uint64_t seed, const std::string& stream)
    : Engine(seed ^ Hash(stream))
  {
  }

  // In [0, 1).
  double Unit() { return double(this->Engine() >> 11) * (1.0 / 9007199254740992.0); }

  double Between(double low, double high) { return low + (high - low) * this->Unit(); }

  // Evenly by magnitude; both positive.
  double Log(double low, double high) { return low * std::pow(high / low, this->Unit()); }

  // 0 .. count - 1.
  int Below(int count) { return int(this->Unit() * count); }

  bool Chance(double probability) { return this->Unit() < probability; }

  double Sign() { return this->Chance(0.5) ? 1 : -1; }

  template <class Value>
  const Value& Choose(const std::vector<Value>& values)
  {
    return values[std::size_t(this->Below(int(values.size())))];
  }

  // Evenly over the sphere.
  vec3 Direction()
  {
    const double z = this->Between(-1, 1);
    const double a = this->Between(0, 2 * WFV_PI);
    const double r = std::sqrt(1 - z * z);
    return vec3(r * std::cos(a), r * std::sin(a), z);
  }

private:
  // FNV-1a.
  static std::uint64_t Hash(const std::string& text)
  {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : text)
    {
      hash = (hash ^ std::uint64_t(static_cast<unsigned char>(c))) * 1099511628211u;
    }
    return hash;
  }

  std::mt19937_64 Engine;
};
}
}

#endif
