import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 4.8768
settings.criterion_preset = 'Plywood 15.9 mm Along Grain'
settings.criterion_source = 'APA, 5/8 in bent along the grain to 16 ft (Concrete Construction, Curving plywood forms)'
