// SPDX-License-Identifier: BSD-3-Clause
#include "Counts.h"

#include <algorithm>

namespace wfv
{
namespace stress
{
namespace
{
struct Field
{
  const char* Name;
  long Counts::*Value;
};

const Field Fields[] = { { "nan", &Counts::Nan }, { "gl_errors", &Counts::GlErrors },
  { "holes", &Counts::Holes }, { "double_hits", &Counts::DoubleHits },
  { "unexplained", &Counts::Unexplained }, { "crashes", &Counts::Crashes },
  { "batches", &Counts::Batches }, { "pixels", &Counts::Pixels },
  { "depth_ties", &Counts::DepthTies }, { "ties", &Counts::Ties }, { "thin", &Counts::Thin },
  { "near", &Counts::Near }, { "hidden", &Counts::Hidden } };
}

void Counts::Add(const Counts& other)
{
  for (const Field& field : Fields)
  {
    this->*field.Value += other.*field.Value;
  }
  this->MaxDepthRel = std::max(this->MaxDepthRel, other.MaxDepthRel);
  this->MaxPx = std::max(this->MaxPx, other.MaxPx);
}

bool Counts::Failed() const
{
  return this->Nan + this->GlErrors + this->Holes + this->DoubleHits + this->Unexplained +
    this->Crashes >
    0;
}

Json ToJson(const Counts& counts)
{
  Json json = Json::object();
  for (const Field& field : Fields)
  {
    json[field.Name] = counts.*field.Value;
  }
  json["max_depth_rel"] = counts.MaxDepthRel;
  json["max_px"] = counts.MaxPx;
  return json;
}

Counts FromJson(const Json& json)
{
  Counts counts;
  for (const Field& field : Fields)
  {
    counts.*field.Value = json.at(field.Name).get<long>();
  }
  counts.MaxDepthRel = json.at("max_depth_rel").get<double>();
  counts.MaxPx = json.at("max_px").get<double>();
  return counts;
}
}
}
