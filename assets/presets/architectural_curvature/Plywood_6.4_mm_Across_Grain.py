import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.6096
settings.criterion_preset = 'Plywood 6.4 mm Across Grain'
settings.criterion_source = 'APA, 1/4 in bent across the grain to 2 ft (Concrete Construction, Curving plywood forms)'
