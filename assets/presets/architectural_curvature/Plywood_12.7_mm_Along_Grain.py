import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 3.6576
settings.criterion_preset = 'Plywood 12.7 mm Along Grain'
settings.criterion_source = 'APA, 1/2 in bent along the grain to 12 ft (Concrete Construction, Curving plywood forms)'
