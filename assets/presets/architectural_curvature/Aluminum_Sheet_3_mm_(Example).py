import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.75
settings.criterion_preset = 'Aluminum Sheet 3 mm (Example)'
settings.criterion_source = 'Example without a source: 250 × thickness, about 140 MPa by E t / 2R with E = 70 GPa; set the radius of your fabricator'
