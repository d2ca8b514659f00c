import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.9144
settings.criterion_preset = 'Aircraft Plywood 9.5 mm 0 to 45 Degrees'
settings.criterion_source = 'FAA AC 43.13-1B, 0.375 in bent dry on a cold mandrel to 36 in, axis at 0 to 45 degrees to the face grain (engineersedge.com)'
