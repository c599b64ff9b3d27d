// SPDX-License-Identifier: BSD-3-Clause
#include "pqWideFoVToolBar.h"

#include "ViewMoves.h"

#include <QComboBox>
#include <QIcon>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

#include <pqActiveObjects.h>
#include <pqUndoStack.h>
#include <pqView.h>

#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMStringListDomain.h>
#include <vtkSMTrace.h>
#include <vtkSMViewProxy.h>

#include "Presets/Presets.h"

namespace
{
pqView* ActiveView()
{
  return pqActiveObjects::instance().activeView();
}

void Apply(const wfv::Preset& preset)
{
  pqView* const view = pqActiveObjects::instance().activeView();
  vtkSMViewProxy* const proxy = wfvplugin::WideProxy(view);
  if (!proxy)
  {
    return;
  }
  BEGIN_UNDO_SET(QString::fromStdString(preset.ViewTitle));
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
    vtkSMPropertyHelper(proxy, "Projection").Set(preset.Projection.c_str());
    vtkSMPropertyHelper(proxy, "HorizontalFieldOfView").Set(preset.HorizontalFov);
    vtkSMPropertyHelper(proxy, "VerticalFieldOfView").Set(preset.VerticalFov);
    vtkSMPropertyHelper(proxy, "Tilt").Set(preset.Tilt);
    vtkSMPropertyHelper(proxy, "StereoRender").Set(preset.TwoEyes ? 1 : 0);
    if (preset.TwoEyes)
    {
      vtkSMPropertyHelper(proxy, "PoleFade").Set(preset.PoleFade.data(), 2);
      proxy->GetProperty("StereoModel")->ResetToXMLDefaults(); // the usual one of such pictures
    }
    proxy->UpdateVTKObjects();
  }
  END_UNDO_SET();
  view->render();
}
}

pqWideFoVToolBar::pqWideFoVToolBar(const QString& title, QWidget* parent)
  : Superclass(title, parent)
{
  this->build();
}

pqWideFoVToolBar::pqWideFoVToolBar(QWidget* parent)
  : Superclass(parent)
{
  this->setWindowTitle("Wide FoV");
  this->build();
}

pqWideFoVToolBar::~pqWideFoVToolBar() = default;

void pqWideFoVToolBar::build()
{
  this->setObjectName("WideFoVToolBar"); // under which the window remembers its place
  this->Projections = new QComboBox(this);
  this->Projections->setObjectName("Projections");
  this->Projections->setToolTip("Projection of the active Wide FoV View");
  this->Projections->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  this->addWidget(this->Projections);

  auto* const button = new QToolButton(this);
  button->setObjectName("Presets");
  button->setText("Presets");
  // its colours stand out from light and dark panels alike
  button->setIcon(QIcon(":/WideFoV/Icons/presets.svg"));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setToolTip("Projection, fields of view, tilt and eyes for a kind of picture");
  button->setPopupMode(QToolButton::InstantPopup);
  auto* const menu = new QMenu(button);
  for (const wfv::Preset& preset : wfv::Presets())
  {
    if (!preset.ViewTitle.empty())
    {
      QObject::connect(menu->addAction(QString::fromStdString(preset.ViewTitle)),
        &QAction::triggered, [&preset] { Apply(preset); });
    }
  }
  button->setMenu(menu);
  this->addWidget(button);
  this->buildMoves();

  QObject::connect(&pqActiveObjects::instance(), &pqActiveObjects::viewChanged, this,
    &pqWideFoVToolBar::followView);
  QObject::connect(
    &this->Links, &pqPropertyLinks::qtWidgetChanged, this, &pqWideFoVToolBar::render);
  // undo changes the property and leaves the picture
  QObject::connect(
    &this->Links, &pqPropertyLinks::smPropertyChanged, this, &pqWideFoVToolBar::render);
  this->followView(pqActiveObjects::instance().activeView());
}

void pqWideFoVToolBar::buildMoves()
{
  QAction* const inside = this->addAction(QIcon(":/WideFoV/Icons/inside.svg"), "Eye into data");
  inside->setObjectName("EyeIntoData");
  inside->setToolTip("Put the eye into the middle of the visible data");
  QObject::connect(inside, &QAction::triggered, [] { wfvplugin::PutEyeIntoData(ActiveView()); });

  auto* const button = new QToolButton(this);
  button->setObjectName("LookAlong");
  button->setText("Look along");
  button->setIcon(QIcon(":/WideFoV/Icons/along.svg"));
  button->setToolTip("Look along an axis, from where the eye is");
  button->setPopupMode(QToolButton::InstantPopup);
  auto* const menu = new QMenu(button);
  for (int i = 0; i < 6; ++i)
  {
    const bool positive = i % 2 == 0;
    const QString name = QString(positive ? "+" : "-") + "XYZ"[i / 2];
    QObject::connect(menu->addAction(name), &QAction::triggered,
      [i, positive] { wfvplugin::LookAlong(ActiveView(), i / 2, positive); });
  }
  button->setMenu(menu);
  this->addWidget(button);

  QAction* const shape = this->addAction("2:1");
  shape->setObjectName("TwoToOne");
  shape->setToolTip(
    "Make the layout twice as wide as high, as a panorama is; again: as the window");
  QObject::connect(shape, &QAction::triggered, [] { wfvplugin::ToggleTwoToOne(ActiveView()); });
}

void pqWideFoVToolBar::followView(pqView* view)
{
  this->Links.clear();
  vtkSMViewProxy* const proxy = wfvplugin::WideProxy(view);
  this->setEnabled(proxy != nullptr);
  const QSignalBlocker quiet(this->Projections);
  this->Projections->clear();
  if (!proxy)
  {
    return;
  }
  vtkSMProperty* const property = proxy->GetProperty("Projection");
  auto* const domain = property->FindDomain<vtkSMStringListDomain>();
  for (unsigned int i = 0; i < domain->GetNumberOfStrings(); i++)
  {
    this->Projections->addItem(domain->GetString(i));
  }
  this->Links.addTraceablePropertyLink(
    this->Projections, "currentText", SIGNAL(currentTextChanged(QString)), proxy, property);
}

void pqWideFoVToolBar::render()
{
  if (pqView* const view = pqActiveObjects::instance().activeView())
  {
    view->render();
  }
}
