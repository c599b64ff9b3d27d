// SPDX-License-Identifier: BSD-3-Clause
// Mappers that a program makes by their stock names classify clusters, too: whatever VTK makes one
// for, and as their own class does.
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkDataSetMapper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
struct SpherePicture
{
  vtkSmartPointer<vtkUnsignedCharArray> Pixels;
  int Clusters;
};

template <typename Mapper>
SpherePicture DrawSphere()
{
  WideFoVTestWindow test("equirectangular", 400, 200);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(3);
  sphere->SetThetaResolution(150);
  sphere->SetPhiResolution(150);
  vtkNew<Mapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  test.Renderer->AddActor(actor);
  test.Window->Render();
  return { TestPixels(test.Window).Data, test.Pass()->GetNumberOfClusters() };
}

bool ShowTheSame(const SpherePicture& a, const SpherePicture& b)
{
  const unsigned char* const values = a.Pixels->GetPointer(0);
  return std::equal(values, values + a.Pixels->GetNumberOfValues(), b.Pixels->GetPointer(0));
}
}

TEST(Overrides, StockMappersClassifyClusters)
{
  const SpherePicture own = DrawSphere<vtkWideFoVPolyDataMapper>();
  EXPECT_GT(own.Clusters, 100);
  const SpherePicture stock = DrawSphere<vtkPolyDataMapper>();
  EXPECT_EQ(stock.Clusters, own.Clusters);
  EXPECT_TRUE(ShowTheSame(stock, own));
  const SpherePicture dataSet = DrawSphere<vtkDataSetMapper>();
  EXPECT_EQ(dataSet.Clusters, own.Clusters);
  EXPECT_TRUE(ShowTheSame(dataSet, own));
}

// Who asks for the class of the OpenGL module itself gets that.
TEST(Overrides, TheClassOfOpenGLIsMadeAsItIs)
{
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  EXPECT_STREQ(mapper->GetClassName(), "vtkOpenGLPolyDataMapper");
  EXPECT_EQ(DrawSphere<vtkOpenGLPolyDataMapper>().Clusters, 0);
}
