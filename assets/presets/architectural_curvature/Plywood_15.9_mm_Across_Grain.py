import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 2.4384
settings.criterion_preset = 'Plywood 15.9 mm Across Grain'
settings.criterion_source = 'APA, 5/8 in bent across the grain to 8 ft (Concrete Construction, Curving plywood forms)'
