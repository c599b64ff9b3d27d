// SPDX-License-Identifier: BSD-3-Clause
// The JSON of widefov-stress, as the contract has it.
#include "Report.h"

#include <gtest/gtest.h>

using namespace wfv::stress;

namespace
{
StressOptions TwoTechniques()
{
  StressOptions o;
  o.Projections = { "hammer" };
  o.Techniques = { "exact", "auto" };
  o.Seed = 4;
  return o;
}

Json ResultOf(const Counts& exact, const Counts& automatic)
{
  Json result = { { "primitives", 500 }, { "shot", "a view" }, { "techniques", Json::object() } };
  result["techniques"]["exact"] = { { "counts", ToJson(exact) }, { "lines", { "a pixel" } } };
  result["techniques"]["auto"] = { { "counts", ToJson(automatic) }, { "lines", Json::array() } };
  return result;
}
}

TEST(StressReport, HasTheFieldsOfTheContract)
{
  const Json json = Report(TwoTechniques()).ToJson();
  for (const char* name :
    { "primitives", "nan", "gl_errors", "holes", "double_hits", "unexplained", "crashes" })
  {
    EXPECT_TRUE(json.at(name).is_number_integer()) << name;
  }
  EXPECT_EQ(json.at("projections"), Json::array({ "hammer" }));
  EXPECT_TRUE(json.at("by_case").is_object());
}

TEST(StressReport, TotalsAreSums)
{
  Report report(TwoTechniques());
  Counts exact;
  exact.Holes = 1;
  exact.Batches = 1;
  Counts automatic;
  automatic.Unexplained = 3;
  automatic.Near = 2;
  automatic.Hidden = 1;
  automatic.MaxDepthRel = 0.5;
  automatic.MaxPx = 0.125;
  report.Add({ "hammer", "needles", 0 }, ResultOf(exact, automatic));
  report.Add({ "hammer", "eye", 0 }, ResultOf(exact, Counts()));
  const Json json = report.ToJson();
  EXPECT_EQ(json["primitives"], 1000);
  EXPECT_EQ(json["holes"], 2);
  EXPECT_EQ(json["unexplained"], 3);
  EXPECT_EQ(json["near"], 2);
  EXPECT_EQ(json["hidden"], 1);
  EXPECT_EQ(json["by_case"]["needles"]["auto"]["unexplained"], 3);
  EXPECT_EQ(json["by_case"]["eye"]["auto"]["unexplained"], 0);
  EXPECT_EQ(json["by_projection"]["hammer"]["exact"]["holes"], 2);
  EXPECT_EQ(json["max_depth_rel"], 0.5);
  EXPECT_EQ(json["max_px"], 0.125);
  ASSERT_EQ(json["failures"].size(), 3u);
  EXPECT_EQ(json["failures"][0]["reproduce"],
    "widefov-stress --seed 4 --projections hammer --technique exact --tolerance 0.02 "
    "--cases needles --batch 0 --output FILE.json");
}

TEST(StressReport, ACrashCountsOnce)
{
  Report report(TwoTechniques());
  report.Add({ "hammer", "needles", 7 }, { { "crash", "signal 11" }, { "technique", "auto" } });
  const Json json = report.ToJson();
  EXPECT_EQ(json["crashes"], 1);
  ASSERT_EQ(json["failures"].size(), 1u);
  EXPECT_EQ(json["failures"][0]["crash"], "signal 11");
  EXPECT_EQ(json["by_case"]["needles"]["auto"]["crashes"], 1);
  EXPECT_EQ(json["by_case"]["needles"]["exact"]["crashes"], 0);
}

TEST(StressReport, FailuresAreBounded)
{
  Report report(TwoTechniques());
  Counts bad;
  bad.Nan = 1;
  for (int i = 0; i < 100; ++i)
  {
    report.Add({ "hammer", "needles", i }, ResultOf(bad, bad));
  }
  EXPECT_EQ(report.ToJson()["failures"].size(), 10u);
  EXPECT_EQ(report.ToJson()["nan"], 200);
}

TEST(StressCounts, SurviveTheWayThroughJson)
{
  Counts counts;
  counts.Nan = 1;
  counts.GlErrors = 2;
  counts.Holes = 3;
  counts.DoubleHits = 4;
  counts.Unexplained = 5;
  counts.Crashes = 6;
  counts.Near = 7;
  counts.Hidden = 8;
  counts.MaxDepthRel = 0.125;
  EXPECT_EQ(ToJson(FromJson(ToJson(counts))), ToJson(counts));
  EXPECT_TRUE(counts.Failed());
  EXPECT_FALSE(Counts().Failed());
}
