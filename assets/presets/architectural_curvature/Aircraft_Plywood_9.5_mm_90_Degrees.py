import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 1.3716
settings.criterion_preset = 'Aircraft Plywood 9.5 mm 90 Degrees'
settings.criterion_source = 'FAA AC 43.13-1B, 0.375 in bent dry on a cold mandrel to 54 in, axis at 90 degrees to the face grain (engineersedge.com)'
