// SPDX-License-Identifier: BSD-3-Clause
// Plans, records and ratios of widefov-bench, as the contract has them.
#include "Projections/DirectionMap.h"
#include "Plan.h"
#include "Summary.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace wfv;
using namespace wfv::bench;

// A test has a member of that name.
using BenchRun = wfv::bench::Run;

namespace
{
std::vector<BenchRun> PlanOf(bool quick, const std::vector<std::string>& methods = {})
{
  PlanRequest request;
  request.Quick = quick;
  request.Methods = methods;
  request.Size = { { 1024, 512 } };
  return MakePlan(request, widefov::Options());
}

Record MakeRecord(const BenchRun& run, double ms, double maxPx)
{
  Record record;
  record.Scene = "room";
  record.Triangles = 12;
  record.Run = run;
  record.Milliseconds = { ms };
  record.Error = ErrorFigures();
  record.Error->Metrics.MaxPx = maxPx;
  record.Error->Metrics.P99Px = maxPx / 2;
  record.Error->Metrics.Mismatched = long(100 * maxPx);
  return record;
}

const BenchRun& Find(const std::vector<BenchRun>& plan, const std::string& name)
{
  for (const BenchRun& run : plan)
  {
    if (NameOf(run) == name)
    {
      return run;
    }
  }
  throw std::runtime_error("no run " + name);
}
}

// The techniques alone draw it; what they are compared with stays as it is.
TEST(BenchPlan, DirectionMapStandsForTheProjection)
{
  PlanRequest request;
  request.Quick = true;
  request.Size = { { 64, 32 } };
  request.Projection = "hammer";
  request.Map = MakeDirectionMap(request.Projection, request.Size);
  EXPECT_EQ(request.Map->GetWidth(), 64);
  EXPECT_EQ(request.Map->GetHeight(), 32);
  for (const BenchRun& run : MakePlan(request, widefov::Options()))
  {
    const bool draws = run.Method == "auto" || run.Method == "exact" || run.Method == "preclip" ||
      run.Method == "vertex";
    EXPECT_EQ(run.Options.Projection == "direction-map", draws) << run.Method;
    EXPECT_EQ(run.Options.View.Map == request.Map, draws) << run.Method;
    EXPECT_EQ(MakeRecord(run, 1, 1).Run.DirectionsOf, draws ? "hammer" : "") << run.Method;
    EXPECT_EQ(ToJson(MakeRecord(run, 1, 1)).contains("directions_of"), draws) << run.Method;
  }
}

TEST(BenchPlan, QuickHasEveryMethodOfOneEyeAndOneCubeMap)
{
  std::set<std::string> methods;
  int cubemaps = 0;
  for (const BenchRun& run : PlanOf(true))
  {
    methods.insert(run.Method);
    cubemaps += run.Method == "cubemap";
    EXPECT_EQ(run.Options.Samples, 0);
  }
  std::set<std::string> all;
  for (const std::string& name : MethodNames())
  {
    if (name.rfind("stereo-", 0) != 0 && name != SmoothCubeMap) // which stands beside samples
    {
      all.insert(name);
    }
  }
  EXPECT_EQ(methods, all);
  EXPECT_EQ(cubemaps, 1);
  EXPECT_EQ(Find(PlanOf(true), "cubemap_326").Options.CubeMapResolution, 326);
}

TEST(BenchPlan, FullHasEveryParameter)
{
  const std::vector<BenchRun> plan = PlanOf(false);
  for (const char* name : { "auto_0.02", "auto_0.05", "auto_0.25", "auto_1", "cubemap_326",
         "cubemap_512", "cubemap_1024", "cubemap_2048", "cubemap_4096", "exact" })
  {
    EXPECT_EQ(NameOf(Find(plan, name)), name);
  }
  EXPECT_EQ(Find(plan, "auto_1").Options.Tolerance, 1);
  EXPECT_EQ(PlanOf(false, { "exact", "floor" }).size(), 2u);
}

TEST(BenchPlan, OneToleranceIsTheOnlyOne)
{
  PlanRequest request;
  request.Methods = { "auto", "exact" };
  request.Tolerance = 0.5;
  const std::vector<BenchRun> plan = MakePlan(request, widefov::Options());
  EXPECT_EQ(plan.size(), 2u);
  EXPECT_EQ(Find(plan, "auto_0.5").Options.Tolerance, 0.5);
}

TEST(BenchPlan, EqualDensityIsTheCircleOverPi)
{
  EXPECT_EQ(EqualDensity(1024), 326);
  EXPECT_EQ(EqualDensity(2048), 652);
}

TEST(BenchPlan, PerspectiveHasSquarePixels)
{
  const widefov::Options o = Find(PlanOf(true), "perspective").Options;
  EXPECT_EQ(o.View.HorizontalFov, 120);
  EXPECT_NEAR(std::tan(o.View.VerticalFov * WFV_PI / 360) * 2, std::tan(WFV_PI / 3), 1e-12);
}

// What is measured of a technique is its own; stock VTK's perspective is a method of its own.
TEST(BenchPlan, TechniquesDrawThePerspectiveThemselves)
{
  PlanRequest request;
  request.Projection = "perspective";
  request.Size = { { 1024, 512 } };
  const std::vector<BenchRun> plan = MakePlan(request, widefov::Options());
  for (const char* name : { "exact", "auto_0.25", "auto_1", "vertex" })
  {
    EXPECT_TRUE(Find(plan, name).Options.ExactPerspective) << name;
  }
  EXPECT_FALSE(Find(plan, "perspective").Options.ExactPerspective);
}

TEST(BenchPlan, Table1HasThePapersRows)
{
  PlanRequest request;
  request.Size = { { 1024, 512 } };
  std::multiset<std::string> rows;
  for (const BenchRun& run : MakeTable1(request, widefov::Options()))
  {
    rows.insert(run.Options.Projection + " " + std::to_string(int(run.Options.View.HorizontalFov)) +
      " " + std::to_string(run.Options.Samples));
  }
  for (const char* view : { "equirectangular 120", "equirectangular 180", "equirectangular 270",
         "equirectangular 360", "hammer 360" })
  {
    EXPECT_EQ(rows.count(view + std::string(" 0")), 2u) << view; // auto and preclip
    EXPECT_EQ(rows.count(view + std::string(" 4")), 2u) << view;
  }
  EXPECT_EQ(rows.count("perspective 120 0"), 1u);
  EXPECT_EQ(rows.count("perspective 120 4"), 1u);
}

TEST(BenchRecord, HasTheFieldsOfTheContract)
{
  const Json json = ToJson(MakeRecord(Find(PlanOf(true), "auto_0.25"), 10, 0.2));
  for (const char* name :
    { "scene", "triangles", "projection", "hfov", "size", "method", "parameter", "ms", "frames" })
  {
    EXPECT_TRUE(json.contains(name)) << name;
  }
  for (const char* name : { "median", "min", "max" })
  {
    EXPECT_TRUE(json.at("ms").at(name).is_number()) << name;
  }
  for (const char* name :
    { "unexplained", "missing", "spurious", "max_px", "p99_px", "max_depth_rel" })
  {
    EXPECT_TRUE(json.at("error").contains(name)) << name;
  }
  EXPECT_EQ(json["method"], "auto");
  EXPECT_EQ(json["parameter"], 0.25);
  EXPECT_EQ(json["hfov"], 360);
}

TEST(BenchRecord, UnknownFiguresAreNull)
{
  Record record;
  record.Run = Find(PlanOf(true), "floor");
  const Json json = ToJson(record);
  EXPECT_TRUE(json["ms"]["median"].is_null());
  EXPECT_TRUE(json["error"].is_null());
  EXPECT_TRUE(json["parameter"].is_null());
  EXPECT_TRUE(json["hfov"].is_null());
  Record cubemap = MakeRecord(Find(PlanOf(true), "cubemap_326"), 1, INFINITY);
  EXPECT_TRUE(ToJson(cubemap)["error"]["max_depth_rel"].is_null());
  EXPECT_EQ(ToJson(cubemap)["error"]["max_px"], reference::SearchLimit);
}

TEST(BenchSummary, RatiosSayWhich)
{
  const std::vector<BenchRun> plan = PlanOf(false);
  const Json json = Summarize({ MakeRecord(Find(plan, "auto_0.25"), 30, 0.2),
    MakeRecord(Find(plan, "floor"), 10, 0), MakeRecord(Find(plan, "cubemap_326"), 20, 5),
    MakeRecord(Find(plan, "cubemap_2048"), 150, 0.2),
    MakeRecord(Find(plan, "cubemap_4096"), 600, 0.1) });
  EXPECT_DOUBLE_EQ(json["time auto_0.25 / floor, room"], 3);
  EXPECT_DOUBLE_EQ(json["time auto_0.25 / cubemap_326, room"], 1.5);
  EXPECT_DOUBLE_EQ(json["time of the cubemap at the max_px of auto_0.25 / auto_0.25, room"], 5);
  EXPECT_FALSE(json.contains("time exact / floor, room"));
}

TEST(BenchSamples, PlansHaveThemInEveryRunAndRatiosSayIt)
{
  PlanRequest request;
  request.Quick = true;
  request.Samples = 4;
  std::vector<Record> records;
  for (const BenchRun& run : MakePlan(request, widefov::Options()))
  {
    EXPECT_EQ(run.Options.Samples, run.Method == SmoothCubeMap ? 0 : 4) << NameOf(run);
    Record record;
    record.Scene = "room";
    record.Run = run;
    record.Milliseconds = { 10 };
    records.push_back(record);
  }
  const Json json = Summarize(records);
  EXPECT_TRUE(json.contains("time auto_0.25 / cubemap_652 with 4 samples, room")) << json.dump(1);
}

// Twice as many pixels both ways, of faces and of the picture, and no samples of its own.
TEST(BenchSamples, TheSmoothCubeMapHasTwiceThePixelsBothWays)
{
  PlanRequest request;
  request.Samples = 4;
  const BenchRun run = Find(MakePlan(request, widefov::Options()), "cubemap-ss_1304");
  EXPECT_EQ(run.Options.CubeMapResolution, 1304);
  EXPECT_EQ(run.Options.Size, (std::array<int, 2>{ { 4096, 2048 } }));
  EXPECT_EQ(run.Options.Samples, 0);
  EXPECT_EQ(run.Options.Technique, widefov::Technique::CubeMap);
  for (const int samples : { 0, 1 })
  {
    request.Samples = samples;
    EXPECT_THROW(Find(MakePlan(request, widefov::Options()), "cubemap-ss_1304"), std::exception);
  }
}

namespace
{
// One record a run, of that many milliseconds.
std::vector<Record> RecordsOf(
  const PlanRequest& request, const std::map<std::string, double>& milliseconds)
{
  std::vector<Record> records;
  for (const BenchRun& run : MakePlan(request, widefov::Options()))
  {
    const auto found = milliseconds.find(NameOf(run));
    Record record;
    record.Scene = "room";
    record.Run = run;
    record.Milliseconds = { found == milliseconds.end() ? 1 : found->second };
    records.push_back(record);
  }
  return records;
}
}

TEST(BenchSummary, MovesAndSamplesAreInTheNamesOfRatios)
{
  PlanRequest request;
  request.Quick = true;
  request.Methods = { "auto", "vertex", "cubemap", "cubemap-ss", "perspective",
    "stereo-omnidirectional" };
  request.Samples = 4;
  for (const auto& [motion, text] : std::vector<std::pair<bench::Motion, std::string>>{
         { { Mode::Turn, 1 }, " while turning" }, { { Mode::Film, 0 }, " in a film" },
         { { Mode::First, 0 }, " of first frames" }, { { Mode::Still, 0 }, "" } })
  {
    request.Motion = motion;
    const Json json = Summarize(RecordsOf(request,
      { { "auto_0.25", 12 }, { "vertex", 6 }, { "cubemap_652", 4 }, { "cubemap-ss_1304", 24 },
        { "perspective", 3 }, { "stereo-omnidirectional", 18 } }));
    const std::string end = text + " with 4 samples, room";
    EXPECT_EQ(json.value("time auto_0.25 / vertex" + end, 0.), 2) << json.dump(1);
    EXPECT_EQ(json.value("time auto_0.25 / cubemap_652" + end, 0.), 3);
    EXPECT_EQ(json.value("time auto_0.25 / cubemap-ss_1304" + end, 0.), 0.5);
    EXPECT_EQ(json.value("time auto_0.25 / perspective" + end, 0.), 4);
    EXPECT_EQ(json.value("time stereo-omnidirectional / auto_0.25" + end, 0.), 1.5);
  }
}

TEST(BenchRecord, SaysTheModeAndTheFirstFrame)
{
  PlanRequest request;
  request.Quick = true;
  for (const std::string& name : ModeNames())
  {
    request.Motion = { ModeOf(name), 0 };
    EXPECT_EQ(NameOf(request.Motion.Mode), name);
    Record record = RecordsOf(request, {}).front();
    EXPECT_EQ(ToJson(record).at("mode"), name);
    EXPECT_TRUE(ToJson(record).at("first_ms").is_null());
    record.FirstMilliseconds = 2.5;
    EXPECT_EQ(ToJson(record).at("first_ms"), 2.5);
  }
}

TEST(BenchTurn, PlansTurnEveryRunButHaveNoFloor)
{
  PlanRequest request;
  request.Quick = true;
  request.Motion = { Mode::Turn, -1.5 };
  const std::vector<BenchRun> turning = MakePlan(request, widefov::Options());
  EXPECT_EQ(turning.size() + 1, PlanOf(true).size());
  for (const BenchRun& run : turning)
  {
    EXPECT_EQ(run.Motion.Degrees, -1.5) << NameOf(run);
    EXPECT_NE(run.Method, "floor");
  }
}

TEST(BenchTurn, OnlyRecordsOfCamerasThatTurnSayIt)
{
  Record record;
  record.Run = Find(PlanOf(true), "auto_0.25");
  record.Milliseconds = { 10 };
  EXPECT_FALSE(ToJson(record).contains("turn"));
  record.Run.Motion = { Mode::Turn, -1.5 };
  EXPECT_EQ(ToJson(record).at("turn"), -1.5);
  EXPECT_TRUE(ToJson(record).at("error").is_null());
}

TEST(BenchTurn, RatiosSayIt)
{
  std::vector<Record> records;
  for (const char* name : { "auto_0.25", "cubemap_326" })
  {
    Record record;
    record.Scene = "room";
    record.Run = Find(PlanOf(true), name);
    record.Run.Motion = { Mode::Turn, 1 };
    record.Milliseconds = { name[0] == 'a' ? 30. : 20. };
    records.push_back(record);
  }
  EXPECT_DOUBLE_EQ(Summarize(records).at("time auto_0.25 / cubemap_326 while turning, room"), 1.5);
  EXPECT_FALSE(Summarize(records).contains("time auto_0.25 / cubemap_326, room"));
}

TEST(BenchSummary, AnErrorThatIsNotReachedIsNull)
{
  const std::vector<BenchRun> plan = PlanOf(false);
  const Json json = Summarize({ MakeRecord(Find(plan, "auto_0.25"), 30, 0.2),
    MakeRecord(Find(plan, "cubemap_4096"), 600, 0.3) });
  const std::string name = "time of the cubemap at the max_px of auto_0.25 / auto_0.25, room";
  ASSERT_TRUE(json.contains(name));
  EXPECT_TRUE(json[name].is_null());
}

TEST(BenchSummary, Table1ComparesWithThePerspective)
{
  PlanRequest request;
  request.Size = { { 1024, 512 } };
  std::vector<Record> records;
  for (const BenchRun& run : MakeTable1(request, widefov::Options()))
  {
    const bool planar = run.Options.Projection == "perspective";
    records.push_back(MakeRecord(run, planar ? 10 : 20, 0));
  }
  const Json json = SummarizeTable1(records);
  EXPECT_DOUBLE_EQ(json["frame rate preclip hammer 360, 4 samples / perspective perspective 120, 4 "
                        "samples, room"],
    0.5);
}
