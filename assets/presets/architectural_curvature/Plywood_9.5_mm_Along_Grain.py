import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 2.4384
settings.criterion_preset = 'Plywood 9.5 mm Along Grain'
settings.criterion_source = 'APA, 3/8 in bent along the grain to 8 ft (Concrete Construction, Curving plywood forms)'
