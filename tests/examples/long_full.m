% Film force of the long bearing, full film (Flores et al. 2009, eqs. 10 and 11), for
%     lubjoint verify --law long_full -- octave-cli long_full.m
% With the argument "wrong": the journal's diameter is used for its radius.
1;

function f = long_full(s, wrong)
  radius = s(:, 4) * ifelse(wrong, 2, 1);
  c = s(:, 5);
  e = s(:, 8:9) ./ c;
  half_spin = (s(:, 6) + s(:, 7)) / 2;
  u = s(:, 10:11) ./ c + half_spin .* [e(:, 2), -e(:, 1)];  % in the frame of the mean spin only squeeze is left
  ratio = hypot(e(:, 1), e(:, 2));
  q = (1 - ratio) .* (1 + ratio);
  scale = s(:, 2) .* s(:, 3) .* radius .^ 3 ./ c .^ 2;
  f = -12 * pi * scale ./ ((2 + ratio .^ 2) .* q .^ 1.5) .* (2 * q .* u + 3 * sum(e .* u, 2) .* e);
endfunction

function x = ifelse(condition, yes, no)
  if condition
    x = yes;
  else
    x = no;
  endif
endfunction

fgetl(stdin);  % header
text = fread(stdin, Inf, "uint8=>char")';
s = reshape(sscanf(strrep(text, ",", " "), "%f"), 11, [])';
f = long_full(s, any(strcmp(argv(), "wrong")));
printf("id,fx,fy\n");
printf("%d,%.17g,%.17g\n", [s(:, 1), f]');
