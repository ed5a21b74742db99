# Adapter for lubjoint verify: put your film force into `film` below, and run
#     lubjoint verify --law LAW -- julia THIS_FILE
# As it stands it has the short bearing's full film, --law short_full. SI units throughout.

# Radial and tangential force on the journal [N]: along r, from the bearing's centre to the journal's, and along t, r
# turned by 90 degrees counter-clockwise. eps = e/c, eps_dot its rate [1/s], gamma_dot the rate of the direction of r
# [rad/s] (0 where e = 0).
function film(viscosity, length, radius, clearance, omega_bearing, omega_journal, eps, eps_dot, gamma_dot)
    # ---- yours from here ----
    a = eps * (omega_journal + omega_bearing - 2gamma_dot)
    q = (1 - eps) * (1 + eps)
    scale = viscosity * radius * length^3 / clearance^2
    radial = -scale * pi * eps_dot * (1 + 2eps^2) / q^2.5
    tangential = scale * pi * a / (2q^1.5)
    # ---- to here ----
    return radial, tangential
end

function main()
    readline(stdin)  # the columns' names
    println("id,fx,fy")
    for line in eachline(stdin)
        fields = split(line, ',')
        viscosity, length, radius, clearance, omega_bearing, omega_journal, ex, ey, vx, vy = parse.(Float64, fields[2:11])
        e = hypot(ex, ey)
        # At the centre r is the direction of the motion; at rest there any will do.
        x, y = e > 0 ? (ex, ey) : (vx, vy)
        size = hypot(x, y)
        rx, ry = size > 0 ? (x / size, y / size) : (1.0, 0.0)
        eps_dot = (vx * rx + vy * ry) / clearance
        gamma_dot = e > 0 ? (vy * rx - vx * ry) / e : 0.0
        radial, tangential = film(viscosity, length, radius, clearance, omega_bearing, omega_journal, e / clearance,
                                  eps_dot, gamma_dot)
        println(fields[1], ',', radial * rx - tangential * ry, ',', radial * ry + tangential * rx)
    end
end

main()
