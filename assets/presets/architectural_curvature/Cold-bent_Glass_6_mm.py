import bpy
settings = bpy.context.scene.curvature

settings.criterion = 'RADIUS'
settings.smallest_radius = 9.0
settings.criterion_preset = 'Cold-bent Glass 6 mm'
settings.criterion_source = '1500 × thickness, according to Sedak (transparence.lv); about 23 MPa by E t / 2R with E = 70 GPa'
