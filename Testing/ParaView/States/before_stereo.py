# SPDX-License-Identifier: BSD-3-Clause
# Python state as the plugin wrote it at commit 1ee83b2, before it had stereo and direction maps.
import paraview
paraview.compatibility.major = 5
paraview.compatibility.minor = 11

#### import the simple module from the paraview
from paraview.simple import *
#### disable automatic camera reset on 'Show'
paraview.simple._DisableFirstRenderCameraReset()

# ----------------------------------------------------------------
# setup views used in the visualization
# ----------------------------------------------------------------

# Create a new 'Wide FoV View'
wideFoVView1 = CreateView('WideFoVView')
wideFoVView1.ViewSize = [240, 120]
wideFoVView1.AxesGrid = 'GridAxes3DActor'
wideFoVView1.StereoType = 0
wideFoVView1.CameraPosition = [0.0, 0.0, -0.7096256958777105]
wideFoVView1.CameraFocalPoint = [0.0, 0.0, -4.0]
wideFoVView1.CameraFocalDisk = 1.0
wideFoVView1.CameraParallelScale = 0.8516115354228021
wideFoVView1.Projection = 'hammer'
wideFoVView1.HorizontalFieldOfView = 300.0
wideFoVView1.VerticalFieldOfView = 150.0
wideFoVView1.Tilt = 20.0
wideFoVView1.AutomaticClipSpheres = 0
wideFoVView1.ClipSpheres = [0.02, 90.0]
wideFoVView1.DepthMapping = 'Logarithmic'
wideFoVView1.Technique = 'Exact'
wideFoVView1.Tolerance = 0.5

SetActiveView(None)

# ----------------------------------------------------------------
# restore active view
SetActiveView(wideFoVView1)
# ----------------------------------------------------------------

# ----------------------------------------------------------------
# setup the data processing pipelines
# ----------------------------------------------------------------

# create a new 'Sphere'
sphere1 = Sphere(registrationName='Sphere1')
sphere1.Center = [0.0, 0.0, -4.0]

# ----------------------------------------------------------------
# setup the visualization in view 'wideFoVView1'
# ----------------------------------------------------------------

# show data from sphere1
sphere1Display = Show(sphere1, wideFoVView1, 'GeometryRepresentation')

# trace defaults for the display properties.
sphere1Display.Representation = 'Surface'
sphere1Display.ColorArrayName = [None, '']
sphere1Display.SelectTCoordArray = 'None'
sphere1Display.SelectNormalArray = 'Normals'
sphere1Display.SelectTangentArray = 'None'
sphere1Display.OSPRayScaleArray = 'Normals'
sphere1Display.OSPRayScaleFunction = 'PiecewiseFunction'
sphere1Display.SelectOrientationVectors = 'None'
sphere1Display.ScaleFactor = 0.1
sphere1Display.SelectScaleArray = 'None'
sphere1Display.GlyphType = 'Arrow'
sphere1Display.GlyphTableIndexArray = 'None'
sphere1Display.GaussianRadius = 0.005
sphere1Display.SetScaleArray = ['POINTS', 'Normals']
sphere1Display.ScaleTransferFunction = 'PiecewiseFunction'
sphere1Display.OpacityArray = ['POINTS', 'Normals']
sphere1Display.OpacityTransferFunction = 'PiecewiseFunction'
sphere1Display.DataAxesGrid = 'GridAxesRepresentation'
sphere1Display.PolarAxes = 'PolarAxesRepresentation'
sphere1Display.SelectInputVectors = ['POINTS', 'Normals']
sphere1Display.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
sphere1Display.ScaleTransferFunction.Points = [-0.9749279022216797, 0.0, 0.5, 0.0, 0.9749279022216797, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
sphere1Display.OpacityTransferFunction.Points = [-0.9749279022216797, 0.0, 0.5, 0.0, 0.9749279022216797, 1.0, 0.5, 0.0]

# ----------------------------------------------------------------
# restore active source
SetActiveSource(sphere1)
# ----------------------------------------------------------------