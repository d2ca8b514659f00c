import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 0.9
settings.criterion_preset = 'Steel Sheet 2 mm (Example)'
settings.criterion_source = 'Example without a source: 450 × thickness, about 233 MPa by E t / 2R with E = 210 GPa; set the radius of your fabricator'
