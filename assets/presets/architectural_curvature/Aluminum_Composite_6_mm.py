import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.2
settings.criterion_preset = 'Aluminum Composite 6 mm'
settings.criterion_source = "A supplier's rule of thumb, weak (aluxacp.com): ask the maker of the sheet"
