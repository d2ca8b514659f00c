import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 6.096
settings.criterion_preset = 'Plywood 19.1 mm Along Grain'
settings.criterion_source = 'APA, 3/4 in bent along the grain to 20 ft (Concrete Construction, Curving plywood forms)'
