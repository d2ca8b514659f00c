import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.508
settings.criterion_preset = 'Aircraft Plywood 6.4 mm 0 to 45 Degrees'
settings.criterion_source = 'FAA AC 43.13-1B, 0.250 in bent dry on a cold mandrel to 20 in, axis at 0 to 45 degrees to the face grain (engineersedge.com)'
