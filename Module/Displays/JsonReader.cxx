// SPDX-License-Identifier: BSD-3-Clause
#include "JsonReader.h"

#include <algorithm>

namespace wfv::displays
{
JsonObject::JsonObject(
  const nlohmann::json& value, std::string where, const std::vector<std::string>& known)
  : Value(value)
  , Place(std::move(where))
{
  std::string names;
  for (const std::string& name : known)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!value.is_object())
  {
    throw FileError(this->Place + " needs an object of " + names);
  }
  for (const auto& item : value.items())
  {
    if (std::find(known.begin(), known.end(), item.key()) == known.end())
    {
      throw FileError(
        this->Place + " has the unknown word '" + item.key() + "'; known are " + names);
    }
  }
}

void JsonObject::Fail(const std::string& name, const std::string& needs) const
{
  throw FileError(this->Where(name) + " needs " + needs);
}

const nlohmann::json& JsonObject::At(const std::string& name) const
{
  if (!this->Has(name))
  {
    throw FileError(this->Place + " has no '" + name + "'");
  }
  return this->Value.at(name);
}

std::string JsonObject::Text(
  const std::string& name, const std::optional<std::string>& otherwise) const
{
  if (!this->Has(name) && otherwise)
  {
    return *otherwise;
  }
  const nlohmann::json& value = this->At(name);
  if (!value.is_string() || value.get<std::string>().empty())
  {
    this->Fail(name, "a text in quotes");
  }
  return value.get<std::string>();
}

double JsonObject::Number(
  const std::string& name, double least, double most, const std::optional<double>& otherwise) const
{
  if (!this->Has(name) && otherwise)
  {
    return *otherwise;
  }
  const nlohmann::json& value = this->At(name);
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= least && number <= most))
  {
    nlohmann::json bounds{ least, most };
    this->Fail(name, "a number from " + bounds[0].dump() + " to " + bounds[1].dump());
  }
  return number;
}

std::vector<double> JsonObject::Numbers(const std::string& name, std::size_t count) const
{
  const nlohmann::json& value = this->At(name);
  const bool fits = value.is_array() && value.size() == count &&
    std::all_of(value.begin(), value.end(), [](const nlohmann::json& n) { return n.is_number(); });
  if (!fits)
  {
    this->Fail(name, std::to_string(count) + " numbers in brackets");
  }
  return value.get<std::vector<double>>();
}

vec3 JsonObject::Vector(const std::string& name, const std::optional<vec3>& otherwise) const
{
  if (!this->Has(name) && otherwise)
  {
    return *otherwise;
  }
  const std::vector<double> v = this->Numbers(name, 3);
  return vec3(v[0], v[1], v[2]);
}

nlohmann::json ParseJson(const std::string& path, const std::string& text)
{
  try
  {
    return nlohmann::json::parse(text, nullptr, true, true);
  }
  catch (const nlohmann::json::out_of_range&)
  {
    throw FileError(path + " has a number that is too large");
  }
  catch (const nlohmann::json::parse_error& error)
  {
    const std::size_t byte = std::min(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(byte), '\n');
    throw FileError(path + ", line " + std::to_string(line) +
      ": this is no JSON; look for a comma, a quote or a bracket there or before");
  }
}
}
