% Adapter for lubjoint verify: put your film force into `film` below, and run
%     lubjoint verify --law LAW -- octave-cli -q THIS_FILE
% In MATLAB, which reads no standard input: lubjoint verify --law LAW --states-out states.csv, then set
% from = 'states.csv' and to = 'answers.csv' below, and lubjoint verify --law LAW --answers answers.csv.
% As it stands it has the short bearing's full film, --law short_full. SI units throughout.
from = '';  % '' is standard input
to = '';    % '' is standard output

if isempty(from)
  fgetl(stdin);  % the columns' names
  text = fread(stdin, Inf, 'uint8=>char')';
else
  text = fileread(from);
  text = text(find(text == sprintf('\n'), 1) + 1:end);
end
s = reshape(sscanf(strrep(text, ',', ' '), '%f'), 11, [])';
c = s(:, 5);
e = hypot(s(:, 8), s(:, 9));
% At the centre r is the direction of the motion; at rest there any will do.
r = s(:, 8:9);
r(e == 0, :) = s(e == 0, 10:11);
r(all(r == 0, 2), :) = repmat([1 0], sum(all(r == 0, 2)), 1);
r = r ./ repmat(hypot(r(:, 1), r(:, 2)), 1, 2);
eps_dot = sum(s(:, 10:11) .* r, 2) ./ c;
gamma_dot = zeros(size(e));
moves = e > 0;
gamma_dot(moves) = (s(moves, 11) .* r(moves, 1) - s(moves, 10) .* r(moves, 2)) ./ e(moves);
viscosity = s(:, 2); length_ = s(:, 3); radius = s(:, 4);
omega_bearing = s(:, 6); omega_journal = s(:, 7);
eps_ = e ./ c;

% Radial and tangential force on the journal [N]: along r, from the bearing's centre to the journal's, and along t, r
% turned by 90 degrees counter-clockwise. eps_ = e/c, eps_dot its rate [1/s], gamma_dot the rate of the direction of r
% [rad/s] (0 where e = 0). All are columns.
% ---- yours from here ----
a = eps_ .* (omega_journal + omega_bearing - 2 * gamma_dot);
q = (1 - eps_) .* (1 + eps_);
scale = viscosity .* radius .* length_ .^ 3 ./ c .^ 2;
radial = -scale .* pi .* eps_dot .* (1 + 2 * eps_ .^ 2) ./ q .^ 2.5;
tangential = scale .* pi .* a ./ (2 * q .^ 1.5);
% ---- to here ----

f = [radial .* r(:, 1) - tangential .* r(:, 2), radial .* r(:, 2) + tangential .* r(:, 1)];
out = 1;
if ~isempty(to)
  out = fopen(to, 'w');
end
fprintf(out, 'id,fx,fy\n');
fprintf(out, '%d,%.17g,%.17g\n', [s(:, 1), f]');
if ~isempty(to)
  fclose(out);
end
