// SPDX-License-Identifier: BSD-3-Clause
// Values of a JSON file, with their place in it for messages.
#ifndef WideFoVJsonReader_h
#define WideFoVJsonReader_h

#include "Calibration.h"

#include <nlohmann/json.hpp>

namespace wfv::displays
{
class JsonObject
{
public:
  // `where`: the file and the place in it. Throws a FileError unless the value is an object whose
  // names are all among `known`.
  JsonObject(const nlohmann::json& value, std::string where, const std::vector<std::string>& known);

  bool Has(const std::string& name) const { return this->Value.contains(name); }
  const nlohmann::json& At(const std::string& name) const;
  std::string Where(const std::string& name) const { return this->Place + "." + name; }

  // Each throws a FileError where the value is missing and `otherwise` too, or is of another kind
  // or out of its bounds.
  std::string Text(const std::string& name, const std::optional<std::string>& otherwise = {}) const;
  double Number(const std::string& name, double least, double most,
    const std::optional<double>& otherwise = {}) const;
  std::vector<double> Numbers(const std::string& name, std::size_t count) const;
  vec3 Vector(const std::string& name, const std::optional<vec3>& otherwise = {}) const;

  [[noreturn]] void Fail(const std::string& name, const std::string& needs) const;

private:
  const nlohmann::json& Value;
  std::string Place;
};

// Throws a FileError that names the line where the text is no JSON. Comments are allowed.
nlohmann::json ParseJson(const std::string& path, const std::string& text);
}

#endif
