import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.9144
settings.criterion_preset = 'Plywood 9.5 mm Across Grain'
settings.criterion_source = 'APA, 3/8 in bent across the grain to 3 ft (Concrete Construction, Curving plywood forms)'
