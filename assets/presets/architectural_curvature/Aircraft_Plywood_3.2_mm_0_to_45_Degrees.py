import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.1803
settings.criterion_preset = 'Aircraft Plywood 3.2 mm 0 to 45 Degrees'
settings.criterion_source = 'FAA AC 43.13-1B, 0.125 in bent dry on a cold mandrel to 7.1 in, axis at 0 to 45 degrees to the face grain (engineersedge.com)'
