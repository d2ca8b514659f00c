import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 3.6576
settings.criterion_preset = 'Plywood 19.1 mm Across Grain'
settings.criterion_source = 'APA, 3/4 in bent across the grain to 12 ft (Concrete Construction, Curving plywood forms)'
