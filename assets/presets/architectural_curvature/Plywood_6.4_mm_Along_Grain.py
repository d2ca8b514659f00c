import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 1.524
settings.criterion_preset = 'Plywood 6.4 mm Along Grain'
settings.criterion_source = 'APA, 1/4 in bent along the grain to 5 ft (Concrete Construction, Curving plywood forms)'
