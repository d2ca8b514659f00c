import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.3048
settings.criterion_preset = 'Aircraft Plywood 3.2 mm 90 Degrees'
settings.criterion_source = 'FAA AC 43.13-1B, 0.125 in bent dry on a cold mandrel to 12 in, axis at 90 degrees to the face grain (engineersedge.com)'
