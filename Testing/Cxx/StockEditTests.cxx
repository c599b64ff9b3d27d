// SPDX-License-Identifier: BSD-3-Clause
// The edits of VTK's shader text (Module/Compat/StockEdits.cxx): on the VTK that runs
// each finds what it looks for, and where one does not, that is said, and nothing half edited is
// drawn.
#include "Compat/Reports.h"
#include "Compat/StockEdits.h"
#include "Overheard.h"
#include "StockEditScenes.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersion.h"
#include "vtkWideFoVDataPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace
{
namespace stock = wfv::stock;
using stock::Edit;

// What VTK says meanwhile, of edits that nothing was said of before.
struct OverheardAnew : Overheard
{
  OverheardAnew() { wfv::ForgetReports(); }
};

// Of the edits that are called with a name: any.
std::string AnyName(Edit edit)
{
  return edit == Edit::Input   ? R"(\w+\s+(?:\w+VSOutput|ip_\w+))"
    : edit == Edit::InputArray ? R"(\w+)"
                               : "";
}

// The same to GLSL, but no more what the edit looks for.
void Break(std::string& text, Edit edit)
{
  for (stock::Span s = stock::Find(text, edit, AnyName(edit)); s.Number >= 0;
       s = stock::Find(text, edit, AnyName(edit)))
  {
    const std::string found = text.substr(s.At, s.Length);
    const auto isLetter = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
    const auto word = std::find_if(found.begin(), found.end(), isLetter);
    const auto place = std::find_if_not(word, found.end(), isLetter);
    const size_t at = s.At + (place == found.end() ? 1 : place - found.begin());
    text.insert(at, place == found.end() ? "X" : "/**/");
  }
}

// A VTK that writes one text in another way: called before the stages are, like the pass of
// somebody else in the prop's list.
class OtherVtk : public vtkOpenGLRenderPass
{
public:
  static OtherVtk* New() { return new OtherVtk; }
  void Render(const vtkRenderState*) override {}

  bool PreReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
    vtkAbstractMapper*, vtkProp*) override
  {
    for (std::string* text : { &vertex, &geometry, &fragment })
    {
      Break(*text, this->Other);
    }
    return true;
  }

  bool PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
    vtkAbstractMapper* mapper, vtkProp* prop) override
  {
    return this->PreReplaceShaderValues(vertex, geometry, fragment, mapper, prop);
  }

  void GiveTo(vtkProp* prop)
  {
    vtkNew<vtkInformation> keys;
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), this);
    prop->SetPropertyKeys(keys);
  }

  Edit Other = Edit::Count;
};

// Levels of 255, without alpha.
std::vector<unsigned char> DrawnData(vtkWideFoVDataPass* pass)
{
  vtkDataArray* const color = pass->GetOutput()->GetPointData()->GetArray("color");
  std::vector<unsigned char> levels;
  for (vtkIdType i = 0; i < 3 * color->GetNumberOfTuples(); i++)
  {
    levels.push_back(static_cast<unsigned char>(255 * color->GetComponent(i / 3, i % 3)));
  }
  return levels;
}

struct BrokenPicture
{
  explicit BrokenPicture(const stockScenes::Scene& scene)
    : Test("equirectangular", 48, 24)
  {
    this->Test.Renderer->SetBackground(0, 0, 0);
    scene.Fill(this->Test);
  }

  // Some scenes set what is one for all mappers.
  ~BrokenPicture() { vtkMapper::SetResolveCoincidentTopologyToDefault(); }

  std::vector<unsigned char> Draw()
  {
    this->Test.Window->Render();
    if (auto* const data = vtkWideFoVDataPass::SafeDownCast(this->Test.Renderer->GetPass()))
    {
      return DrawnData(data);
    }
    const TestPixels pixels(this->Test.Window);
    const unsigned char* const first = pixels.At(0, 0);
    return { first, first + pixels.Data->GetNumberOfValues() };
  }

  void BreakAll(OtherVtk* other)
  {
    vtkPropCollection* const props = this->Test.Renderer->GetViewProps();
    vtkCollectionSimpleIterator it;
    props->InitTraversal(it);
    while (vtkProp* prop = props->GetNextProp(it))
    {
      other->GiveTo(prop);
    }
  }

  WideFoVTestWindow Test;
};

bool IsBlack(const std::vector<unsigned char>& picture)
{
  return std::all_of(picture.begin(), picture.end(), [](unsigned char c) { return c == 0; });
}

int RunningVtk()
{
  return 100 * vtkVersion::GetVTKMajorVersion() + vtkVersion::GetVTKMinorVersion();
}

// Of the VTK that runs; a development version may have what the next release has.
bool IsOfThisVtk(const stock::Entry& entry)
{
  return std::any_of(entry.Wordings.begin(), entry.Wordings.end(),
    [](const stock::Wording& w) { return w.Since <= RunningVtk(); });
}

std::vector<int> TimesFound()
{
  std::vector<int> times;
  for (const stock::Entry& entry : stock::Table())
  {
    times.push_back(stock::TimesFound(entry.Which));
  }
  return times;
}

// Of edits; what follows from one that found nothing may be another. Each is said once.
int CountReports(const Overheard& vtk)
{
  int n = 0;
  for (const stock::Entry& entry : stock::Table())
  {
    n += vtk.Count(std::string("the edit \"") + entry.Name + "\"") > 0;
  }
  return n;
}

using Users = std::map<Edit, std::vector<const stockScenes::Scene*>>;

// The scenes whose shaders an edit finds something in, each drawn once for all tests.
const Users& FindUsers()
{
  static Users users;
  if (!users.empty())
  {
    return users;
  }
  for (const stockScenes::Scene& scene : stockScenes::All())
  {
    const OverheardAnew vtk;
    const std::vector<int> before = TimesFound();
    BrokenPicture picture(scene);
    EXPECT_FALSE(IsBlack(picture.Draw())) << scene.Name;
    // a camera that is not wide says so, once a process
    const int flat = vtk.Count("the picture is flat");
    EXPECT_TRUE(flat == 0 || std::string(scene.Name) == "data, flat camera") << scene.Name;
    EXPECT_EQ(vtk.Count("Warning:") + vtk.Count("ERROR:") - flat, 0) << scene.Name << vtk.All();
    const std::vector<int> after = TimesFound();
    for (const stock::Entry& entry : stock::Table())
    {
      const auto i = static_cast<size_t>(entry.Which);
      if (after[i] > before[i])
      {
        users[entry.Which].push_back(&scene);
      }
    }
  }
  return users;
}
}

TEST(StockEdits, TheTableIsInOrder)
{
  ASSERT_EQ(stock::Table().size(), static_cast<size_t>(Edit::Count));
  for (size_t i = 0; i < stock::Table().size(); i++)
  {
    EXPECT_EQ(static_cast<size_t>(stock::Table()[i].Which), i) << stock::Table()[i].Name;
    EXPECT_FALSE(stock::Table()[i].Wordings.empty()) << stock::Table()[i].Name;
  }
}

TEST(StockEdits, EachFindsItsTextInThisVtk)
{
  const Users& users = FindUsers();
  for (const stock::Entry& entry : stock::Table())
  {
    EXPECT_TRUE(users.count(entry.Which) > 0 || !IsOfThisVtk(entry))
      << "no scene has the text of \"" << entry.Name << "\"";
  }
}

// Once of each, whatever is drawn how often, and nothing half edited.
TEST(StockEdits, OneThatFindsNothingIsSaidAndLeavesThePropOut)
{
  for (const auto& [edit, scenes] : FindUsers())
  {
    const stock::Entry& entry = stock::Table()[static_cast<size_t>(edit)];
    if (entry.Optional)
    {
      continue;
    }
    for (const stockScenes::Scene* scene : { scenes.front(), scenes.back() })
    {
      if (scene->Flat && edit == Edit::Declarations)
      {
        continue; // without that VTK draws nothing either
      }
      const OverheardAnew vtk;
      vtkNew<OtherVtk> other;
      other->Other = edit;
      BrokenPicture picture(*scene);
      picture.BreakAll(other);
      const bool black = IsBlack(picture.Draw());
      picture.Test.Camera->Yaw(10);
      picture.Draw();
      EXPECT_TRUE(black || scene->Flat) << entry.Name << " in " << scene->Name;
      EXPECT_EQ(vtk.Count(std::string("the edit \"") + entry.Name + "\""), 1)
        << entry.Name << " in " << scene->Name << ": " << vtk.All();
      EXPECT_EQ(vtk.Count("ERROR"), CountReports(vtk)) << vtk.All();
      EXPECT_GE(vtk.Count(vtkVersion::GetVTKVersion()), 1) << vtk.All();
      EXPECT_GE(vtk.Count("(VTK 9.1)"), 1) << vtk.All();
      EXPECT_EQ(vtk.Count("(VTK after 9.7)") > 0, edit == Edit::LightPlace) << vtk.All();
    }
  }
}

namespace
{
// Of a pattern what some VTK writes, in the order of the wordings; the name is n.
const std::map<Edit, std::vector<const char*>>& Written()
{
  static const std::map<Edit, std::vector<const char*>> written{
    { Edit::MainFunction, { "void main()" } },
    { Edit::FromEye, { "MCDCMatrix * vertexMC" } },
    { Edit::OutputArray, { "out float clipDistancesVSOutput[6];" } },
    { Edit::CylinderAxis, { "out float lengthVCVSOutput;\nout vec3 orientVCVSOutput;" } },
    { Edit::Input, { "flat in n;" } },
    { Edit::InputArray, { "in float n[6];" } },
    { Edit::HeadlightCosine,
      { "max(0.0,normalVCVSOutput.z)", "max(0.000001, normalVCVSOutput.z)" } },
    { Edit::LightDirection, { "lightDirectionVC0" } },
    { Edit::VolumeToEye, { "normalize(g_eyePosObjs[0].xyz - ip_vertexPos)" } },
    { Edit::VolumeLight, { "in_lightDirection[lightNum]", "in_lightDirection[dirNum]" } },
    { Edit::SkyLookup, { "textureLod(actortexture," } },
    { Edit::LineNormal, { "normalize(cross(vec3(fdx.y, -fdx.x, 0.0), fdx))" } },
  };
  return written;
}

// A shader that has a wording.
std::string TextWith(const stock::Entry& entry, size_t i)
{
  const stock::Wording& wording = entry.Wordings[i];
  if (wording.Pattern)
  {
    const auto found = Written().find(entry.Which);
    return found != Written().end() && i < found->second.size() ? found->second[i] : "";
  }
  std::string text = std::string(wording.Text) + (wording.Last ? wording.Last : "");
  if (const size_t at = text.find('@'); at != std::string::npos)
  {
    text.replace(at, 1, "n");
  }
  return text;
}
}

// The wordings of other VTKs too, and what is optional is no error.
TEST(StockEdits, EveryWordingIsFoundAndReplaced)
{
  for (const stock::Entry& entry : stock::Table())
  {
    std::string nothing = "void other() {}\n";
    EXPECT_EQ(stock::Replace(nothing, entry.Which, "x", stock::Found::Must, "n"), -1) << entry.Name;
    const std::vector<Edit> missing = stock::Missing(nothing);
    EXPECT_EQ(missing, entry.Optional ? std::vector<Edit>() : std::vector<Edit>{ entry.Which });
    std::string may = "void other() {}\n";
    stock::Replace(may, entry.Which, "x", stock::Found::May, "n");
    EXPECT_EQ(may, "void other() {}\n") << entry.Name;
    for (size_t i = 0; i < entry.Wordings.size(); i++)
    {
      const std::string written = TextWith(entry, i);
      std::string text = "a(" + written + ")";
      EXPECT_EQ(
        stock::Replace(text, entry.Which, "[$&]", stock::Found::Must, "n"), static_cast<int>(i))
        << entry.Name << ": " << entry.Wordings[i].Text;
      EXPECT_EQ(text, "a([" + written + "])");
    }
  }
}

TEST(StockEdits, WhatIsBesideAPropThatIsLeftOutIsDrawnAsBefore)
{
  std::vector<unsigned char> alone;
  for (bool broken : { false, true })
  {
    const OverheardAnew vtk;
    WideFoVTestWindow test("equirectangular", 96, 48);
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(2, 0, 0);
    test.Renderer->AddActor(MakeTestActor(ball, 0.9, 0.5, 0.2));
    vtkNew<OtherVtk> other;
    other->Other = Edit::HeadlightCosine;
    if (broken)
    {
      auto room = MakeTestRoom();
      other->Other = Edit::FlatNormal;
      other->GiveTo(room);
      room->GetProperty()->SetInterpolationToFlat();
      test.Renderer->AddActor(room);
    }
    test.Window->Render();
    const TestPixels pixels(test.Window);
    const unsigned char* const first = pixels.At(0, 0);
    const std::vector<unsigned char> drawn{ first, first + pixels.Data->GetNumberOfValues() };
    if (broken)
    {
      EXPECT_EQ(drawn, alone);
    }
    alone = drawn;
    EXPECT_EQ(vtk.Count("ERROR"), broken) << vtk.All();
  }
}

TEST(StockEdits, SelectionFindsNothingOfAPropThatIsLeftOut)
{
  const OverheardAnew vtk;
  vtkNew<OtherVtk> other;
  other->Other = Edit::FromEye;
  BrokenPicture picture(stockScenes::All().front());
  picture.BreakAll(other);
  picture.Draw();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(picture.Test.Renderer);
  selector->SetArea(0, 0, 47, 23);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  EXPECT_TRUE(!selection || selection->GetNumberOfNodes() == 0);
  EXPECT_EQ(vtk.Count("ERROR"), 1) << vtk.All();
}
