import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.6096
settings.criterion_preset = 'Plywood 7.9 mm Across Grain'
settings.criterion_source = 'APA, 5/16 in bent across the grain to 2 ft (Concrete Construction, Curving plywood forms)'
