"""From measured gears and trains to what differs from their design.

| module               | what it holds                                                                     |
|----------------------|-----------------------------------------------------------------------------------|
| `record_kinds`       | kinds of records of a train: angles at its input and output, with torque or not   |
| `encoder_angles`     | angles counted on over whole turns; refusal of those that no train has            |
| `train_orders`       | shafts, wheels and meshes of a train by their orders, and how run-out shows there |
| `transmission_error` | angles -> play, wind-up, rate, and lines of the transmission error by order       |
| `flank_kinds`        | kinds of records of one gear: pitch, profile and helix lines, spans, balls        |
| `flank_lines`        | flank lines -> deviations of ISO 1328-1, and the errors that they come from       |
| `wheel_errors`       | lines at the order of a shaft -> run-out of its wheels, or of its encoder         |
"""
