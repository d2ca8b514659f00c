import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 1.8288
settings.criterion_preset = 'Plywood 7.9 mm Along Grain'
settings.criterion_source = 'APA, 5/16 in bent along the grain to 6 ft (Concrete Construction, Curving plywood forms)'
