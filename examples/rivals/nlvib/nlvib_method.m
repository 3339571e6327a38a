% Harmonic balance or shooting of NLvib as a method of signorini: one JSON request per line, one answer per line.
% usage: octave-cli nlvib_method.m harmonic-balance | shooting
%
% NLVIB is the folder of its sources (the one with solve_and_continue.m), which the user has fetched.
% The response curve is followed by NLvib's arc length from a frequency at which nothing touches to the scene's, where
% one more Newton solve at fixed frequency ends it.
1;

function answer = not_converged(message)
  answer = struct("verdict", "not-converged", "message", message);
end

function A = full_matrix(entries, n)
  A = full(sparse(entries.row(:) + 1, entries.column(:) + 1, entries.value(:), n, n));
end

% NLvib knows loads of the first harmonic alone.
function [load, known] = first_harmonic(force, n)
  load = zeros(n, 1);
  known = true;
  for term = reshape(force, 1, [])
    known = known && term.harmonic == 1;
    load(term.dof + 1) += term.cos - 1i * term.sin;
  end
end

function w = normal_of(contact, n)
  w = zeros(n, 1);
  pairs = contact.normal;
  if iscell(pairs), pairs = cell2mat(cellfun(@(p) reshape(p, 1, []), pairs(:), "UniformOutput", false)); end
  if isvector(pairs), pairs = reshape(pairs, 1, 2); end
  w(pairs(:, 1) + 1) = pairs(:, 2);
end

function springs = springs_of(problem, K, options)
  n = problem.size;
  contacts = problem.contacts;
  springs = {};
  for j = 1:numel(contacts)
    w = normal_of(contacts(j), n);
    if isfield(problem.law, "penalty")
      stiffness = problem.law.penalty(min(j, numel(problem.law.penalty)));
    else
      stiffness = options.stiffness / (w' * (K \ w));
    end
    springs{end + 1} = struct("type", "unilateralSpring", "stiffness", stiffness, "gap", contacts(j).gap, ...
                              "force_direction", w);
  end
end

% Contacts of displacements u and velocities v, n x N, at N instants of a period.
function trajectory = motion_of(u, v, system, omega)
  count = columns(u);
  x = []; velocity = []; force = [];
  for j = 1:numel(system.nonlinear_elements)
    spring = system.nonlinear_elements{j};
    x(j, :) = spring.force_direction' * u;
    velocity(j, :) = spring.force_direction' * v;
    force(j, :) = -spring.stiffness * max(0, x(j, :) - spring.gap);
  end
  rows = @(A) arrayfun(@(j) A(j, :), 1:size(A, 1), "UniformOutput", false);
  trajectory = struct("t", 2 * pi / omega * (0:count - 1) / count);
  trajectory.x = rows(x);
  trajectory.velocity = rows(velocity);
  trajectory.force = rows(force);
end

% What both analyses of NLvib are made of: a residual of X = [x; omega] to `follow` the curve with, and those that Newton's
% method takes one after the other at its end, `start` from amplitudes of a motion without contact, `motion` of a solution,
% and what a residual is `size`d by.
function analysis = harmonic_balance(system, options)
  H = options.harmonics;
  n = system.n;
  analysis.follow = @(X) HB_residual(X, system, H, options.samples, "FRF");
  analysis.residuals = {analysis.follow};
  analysis.start = @(linear, omega) [zeros(n, 1); real(linear); -imag(linear); zeros(2 * (H - 1) * n, 1)];
  analysis.size = @(x) norm(system.Fex1);
  analysis.motion = @(X) series_motion(X, system, H, max(8192, 16 * H));
end

function trajectory = series_motion(X, system, H, count)
  n = system.n;
  omega = X(end);
  Q = zeros(n, H + 1);
  Q(:, 1) = X(1:n);
  for h = 1:H
    Q(:, h + 1) = X((2 * h - 1) * n + (1:n)) - 1i * X(2 * h * n + (1:n));
  end
  waves = exp(2i * pi * (0:H)' * (0:count - 1) / count);
  trajectory = motion_of(real(Q * waves), real((Q .* (1i * omega * (0:H))) * waves), system, omega);
  trajectory.bandwidth = H;
end

% Its velocities are those of the time omega t. Newton's method of a step ends at 1e-4 of the force scale.
function analysis = shooting(system, options)
  at = @(steps) (@(X) shooting_residual(X, system, steps, 1, "FRF", 1, 1e-6 * norm(system.Fex1)));
  coarse = min(options.steps, options.coarse);
  analysis.follow = at(coarse);
  analysis.residuals = arrayfun(at, [coarse * 2 .^ (1:floor(log2((options.steps - 1) / coarse))), options.steps], ...
                                "UniformOutput", false);
  analysis.start = @(linear, omega) [real(linear); -imag(linear)];
  analysis.size = @(x) norm(x);
  analysis.motion = @(X) stepped_motion(X, system, analysis.residuals{end});
end

function trajectory = stepped_motion(X, system, residual)
  [~, ~, ~, Y] = residual(X);
  n = system.n;
  trajectory = motion_of(Y(:, 1:n)', X(end) * Y(:, n + (1:n))', system, X(end));
end

% On each side of the scene's frequency the nearest of four at which nothing touches, `from` times apart; the nearer one
% first. Where there is none, the nearest: Newton's method then begins at the motion without contact all the same.
function begins = contact_free_frequencies(omega, system, options)
  begins = [];
  for power = 1:4
    for begin = omega * options.from .^ [power, -power]
      linear = (-begin^2 * system.M + 1i * begin * system.D + system.K) \ system.Fex1;
      is_free = cellfun(@(spring) abs(spring.force_direction' * linear) < spring.gap, system.nonlinear_elements);
      if all(is_free) && !any((begins > omega) == (begin > omega)), begins(end + 1) = begin; end
    end
  end
  if isempty(begins), begins = omega * [options.from, 1 / options.from]; end
end

% Points of the response curve from the contact-free motion at frequency `begin`, columns [X; omega].
function [X, iterations] = curve_from(begin, omega, system, analysis, options)
  linear = (-begin^2 * system.M + 1i * begin * system.D + system.K) \ system.Fex1;
  start = analysis.start(linear, begin);
  follow = analysis.follow;
  settings = struct("Dscale", [max(abs(linear)) * ones(size(start)); omega], "dynamicDscale", 1, "stoponerror", 0, ...
                    "reversaltolerance", Inf, "stepmax", 500);  % through folds, however far they lead
  newton = optimset("Display", "off", "Jacobian", "on", "MaxIter", 50);  % its own, in words that Octave takes
  [X, info] = solve_and_continue(start, follow, begin, omega, options.step * omega, settings, {}, newton);
  iterations = sum(info.NIT);
end

function answer = solve_problem(problem, options, kind)
  n = problem.size;
  [load, known] = first_harmonic(problem.force, n);
  if !known || problem.subharmonic != 1
    answer = not_converged("NLvib has loads of the first harmonic, and motions of their period");
    return
  end
  K = full_matrix(problem.stiffness, n);
  system = MechanicalSystem(full_matrix(problem.mass, n), full_matrix(problem.damping, n), K, ...
                            springs_of(problem, K, options), load);
  omega = problem.frequency;
  analysis = kind(system, options);
  tight = optimset("Display", "off", "Jacobian", "on", "MaxIter", 40, "TolFun", 1e-12, "TolX", 1e-12);
  iterations = 0;
  points = 0;
  % From one side the curve may turn back at a fold before it is there: then from the other.
  for begin = contact_free_frequencies(omega, system, options)
    try
      [X, steps] = curve_from(begin, omega, system, analysis, options);
    catch
      continue  % it gives up with an error
    end
    iterations += steps;
    points += size(X, 2);
    [gap, nearest] = min(abs(X(end, :) - omega));
    if gap > 10 * options.step * omega, continue; end
    scale = max(abs(X(1:end - 1, nearest)));
    x = X(1:end - 1, nearest) / scale;
    for residual = analysis.residuals
      [x, rest] = fsolve(@(x) residual_at(x, omega, residual{1}, scale), x, tight);
    end
    rest = norm(rest) / analysis.size(x * scale);
    if !(rest <= 1e-8), continue; end
    answer = struct("verdict", "converged", "residual", rest);
    answer.message = sprintf("%d points of the response curve from %.4g rad/s", points, begin);
    answer.work = struct("unknowns", numel(x), "iterations", iterations, "points", points);
    answer.trajectory = analysis.motion([x * scale; omega]);
    return
  end
  answer = not_converged(sprintf("%d points of response curves from frequencies without contact do not reach %.4g rad/s", ...
                                 points, omega));
end

% The response curve between two frequencies by NLvib's own arc length, from a frequency beyond each of them to the other one.
function answer = follow_curve(problem, options, kind, interval)
  n = problem.size;
  [load, known] = first_harmonic(problem.force, n);
  if !known || problem.subharmonic != 1
    answer = struct("unfinished", "NLvib has loads of the first harmonic, and motions of their period");
    answer.branches = {};
    return
  end
  K = full_matrix(problem.stiffness, n);
  system = MechanicalSystem(full_matrix(problem.mass, n), full_matrix(problem.damping, n), K, ...
                            springs_of(problem, K, options), load);
  low = min(interval.from, interval.to);
  high = max(interval.from, interval.to);
  analysis = kind(system, options);
  branches = {};
  reasons = {};
  below = contact_free_frequencies(low, system, options);
  above = contact_free_frequencies(high, system, options);
  below = [below(below < low), low / options.from](1);
  above = [above(above > high), high * options.from](1);
  for way = [below, above; high, low]
    try
      [X, ~] = curve_from(way(1), way(2), system, analysis, options);
    catch failure
      reasons{end + 1} = failure.message;
      continue
    end
    points = {};
    for column = 1:size(X, 2)
      if X(end, column) < low || X(end, column) > high, continue; end
      motion = analysis.motion(X(:, column));
      count = numel(motion.t);
      divisors = 1:max(1, floor(count / 512));  % at least 512 instants, equidistant around the period
      stride = divisors(mod(count, divisors) == 0)(end);
      rows = cellfun(@(x) x(1:stride:end), motion.x, "UniformOutput", false);
      points{end + 1} = struct("omega", X(end, column), "x", {rows});
    end
    if numel(points) > 1
      branches{end + 1} = struct("sequence", sprintf("from %.4g rad/s", way(1)), "points", {points});
    end
  end
  answer.branches = branches;
  answer.unfinished = strjoin(reasons, "; ");
end

function [R, J] = residual_at(x, omega, residual, scale)
  [R, dR] = residual([x * scale; omega]);
  J = dR(:, 1:end - 1) * scale;
end

function answer = answer_to(request, kind)
  follows = isfield(request, "follow");
  try
    if follows
      answer = follow_curve(request.problem, request.options, kind, request.follow);
    else
      answer = solve_problem(request.problem, request.options, kind);
    end
  catch failure
    answer = not_converged(failure.message);
    if follows, answer = struct("branches", {{}}, "unfinished", failure.message); end
  end
end

sources = getenv("NLVIB");
if isempty(sources)
  fprintf(stderr, "NLVIB must name the folder of NLvib's sources\n");
  exit(2);
end
kinds = struct("harmonic_balance", @harmonic_balance, "shooting", @shooting);
kind = kinds.(strrep(argv(){end}, "-", "_"));
addpath(sources, fullfile(sources, "MechanicalSystems"));
warning("off", "all");
while true
  % fgetl would wait for the first letter of the next request.
  try, line = input("", "s"); catch, break; end
  request = jsondecode(line);
  clock_start = tic;
  evalc("answer = answer_to(request, kind);");  % NLvib prints where a step does not converge
  answer.seconds = toc(clock_start);
  printf("%s\n", jsonencode(answer, "ConvertInfAndNaN", false));
  fflush(stdout);
end
