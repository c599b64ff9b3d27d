// SPDX-License-Identifier: BSD-3-Clause
// Hands for ParaView's window: a library that is loaded before the program, waits for the script
// and the plugin's toolbar, uses it as a person would, photographs the screen and ends the program.
// WIDEFOV_PHOTOGRAPHS in the environment names the folder for the pictures, and for the log that
// the script begins as its last step.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QPalette>
#include <QPixmap>
#include <QScreen>
#include <QStyleFactory>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace
{
constexpr int Pause = 1500; // milliseconds between steps: a frame of two eyes on a busy machine

[[noreturn]] void End(int code, const char* text)
{
  std::fprintf(stderr, "window driver: %s\n", text);
  std::fflush(stderr);
  std::_Exit(code); // no question about what is not saved
}

template <typename Widget>
Widget* Find(const char* name)
{
  for (QWidget* top : QApplication::topLevelWidgets())
  {
    if (auto* const found = top->findChild<Widget*>(name))
    {
      return found;
    }
  }
  return nullptr;
}

template <typename Widget>
Widget* Get(const char* name)
{
  auto* const found = Find<Widget>(name);
  return found ? found : (End(1, (std::string("there is no ") + name).c_str()), nullptr);
}

std::string InFolder(const std::string& name)
{
  return std::string(std::getenv("WIDEFOV_PHOTOGRAPHS")) + "/" + name;
}

void Photograph(const std::string& name)
{
  const QPixmap photograph = QGuiApplication::primaryScreen()->grabWindow(0);
  const std::string file = InFolder(name + ".png");
  if (!photograph.save(QString::fromStdString(file)))
  {
    End(1, ("cannot write " + file).c_str());
  }
}

QToolBar* Bar()
{
  return Get<QToolBar>("WideFoVToolBar");
}

void Choose(const char* projection)
{
  Bar()->findChild<QComboBox*>("Projections")->setCurrentText(projection);
}

// What the properties panel shows; other panels have a box of that name as well.
void Search(const char* text)
{
  for (QWidget* top : QApplication::topLevelWidgets())
  {
    for (auto* box : top->findChildren<QWidget*>("SearchBox"))
    {
      auto* const line = box->findChild<QLineEdit*>();
      if (line && line->isVisible())
      {
        line->setText(text);
      }
    }
  }
}

void OpenPresets()
{
  // its menu has an event loop of its own
  QTimer::singleShot(0, Bar()->findChild<QToolButton*>("Presets"), &QToolButton::showMenu);
}

void ChoosePreset(const char* title)
{
  QMenu* const menu = Bar()->findChild<QToolButton*>("Presets")->menu();
  for (QAction* action : menu->actions())
  {
    if (action->text() == title)
    {
      menu->close();
      action->trigger();
      return;
    }
  }
  End(1, (std::string("there is no preset ") + title).c_str());
}

void Move(const char* button)
{
  Bar()->findChild<QAction*>(button)->trigger();
}

void Look(const char* axis)
{
  for (QAction* action : Bar()->findChild<QToolButton*>("LookAlong")->menu()->actions())
  {
    if (action->text() == axis)
    {
      action->trigger();
    }
  }
}

void Darken()
{
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QPalette dark(QColor(53, 53, 53));
  dark.setColor(QPalette::Base, QColor(35, 35, 35));
  dark.setColor(QPalette::Highlight, QColor(42, 130, 218));
  QApplication::setPalette(dark);
}

std::vector<std::function<void()>> Steps()
{
  return { [] {}, [] { Photograph("panorama"); }, [] { Choose("hammer"); },
    [] { Photograph("hammer"); }, [] { Get<QAction>("actionEditUndo")->trigger(); },
    [] { Photograph("undone"); }, [] { Move("EyeIntoData"); }, [] { Photograph("inside"); },
    [] { Look("+X"); }, [] { Photograph("along"); },
    [] { Get<QAction>("actionEditCameraUndo")->trigger(); }, [] { Move("TwoToOne"); },
    [] { Photograph("two-to-one"); }, [] { Move("TwoToOne"); }, [] { OpenPresets(); },
    [] { Photograph("presets"); }, [] { ChoosePreset("Planetarium dome, two eyes"); },
    [] { Photograph("dome"); }, [] { Search("stereo"); }, [] { Photograph("stereo"); },
    [] { Darken(); }, [] {}, [] { Photograph("dark"); }, [] { End(0, "done"); } };
}

// ParaView greets with a window in the way, at any time.
void CloseGreeting()
{
  if (QWidget* const greeting = QApplication::activeModalWidget())
  {
    greeting->close();
  }
}

void Work()
{
  static const std::vector<std::function<void()>> steps = Steps();
  static std::size_t next = 0;
  CloseGreeting();
  auto* const bar = Find<QToolBar>("WideFoVToolBar");
  if (next == 0 && !(bar && bar->isEnabled() && std::ifstream(InFolder("settings.log"))))
  {
    return; // the script is still at work; ParaView 6.1 sees to timers in between
  }
  if (next == 0)
  {
    bar->window()->setGeometry(QGuiApplication::primaryScreen()->geometry());
  }
  steps[next++]();
}

void Start()
{
  if (std::getenv("WIDEFOV_PHOTOGRAPHS") && qobject_cast<QApplication*>(qApp))
  {
    auto* const timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, Work);
    timer->start(Pause);
  }
}
}

Q_COREAPP_STARTUP_FUNCTION(Start)
