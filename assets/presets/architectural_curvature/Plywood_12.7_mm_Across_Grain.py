import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 1.8288
settings.criterion_preset = 'Plywood 12.7 mm Across Grain'
settings.criterion_source = 'APA, 1/2 in bent across the grain to 6 ft (Concrete Construction, Curving plywood forms)'
