// This gives members of the ensemble some inputs. src/thirdbody/conditioning.py says why the others follow.

import { content } from "./content.js";

const { inputs: INPUTS, conditioning: CONDITIONING } = content;
const SWEEPS = 12; // of rotations, which converge quadratically

// The members nearest to what is given. Each has it, and moves its other calibrated inputs by their regression on it.
export function conditioned(members, given) {
  const differing = Object.keys(INPUTS).filter((name) => !INPUTS[name].allowed && new Set(members.map((each) => each[name])).size > 1);
  const [known, others] = [true, false].map((isKnown) => differing.filter((name) => name in given === isKnown));
  if (!known.length) return members.map((member) => ({ ...member, ...given }));
  const here = known.map((name) => members.map((member) => scaled(name, member[name])));
  const units = here.map((column) => d3.deviation(column));
  const deviations = here.map((column, k) => centred(column).map((value) => value / units[k]));
  const wanted = known.map((name) => scaled(name, given[name]));
  const targets = wanted.map((value, k) => reached(value, d3.extent(here[k])));
  const pseudoInverse = inverseOf(deviations.map((one) => deviations.map((other) => dot(one, other))));
  const slopes = others.map((name) => {
    const there = centred(members.map((member) => scaled(name, member[name])));
    const products = deviations.map((column) => dot(column, there));
    return pseudoInverse.map((row) => dot(row, products));
  });
  const steps = (ends, i) => ends.map((end, k) => (end - here[k][i]) / units[k]);
  const distances = members.map((_, i) => (i ? Math.hypot(...steps(wanted, i)) : 0));
  return nearest(distances).map((i) => {
    const moved = others.map((name, j) => [name, changedBy(name, members[i][name], dot(steps(targets, i), slopes[j]))]);
    return { ...members[i], ...Object.fromEntries(moved), ...given };
  });
}

const isPositive = (name) => INPUTS[name].least > 0;
const scaled = (name, value) => (isPositive(name) ? Math.log(value) : value);
const dot = (one, other) => d3.sum(one, (value, i) => value * other[i]);
const centred = (column) => column.map((value) => value - d3.mean(column));

// Members tell of targets from their least to their most, and as far again. Others move to the end of that.
const reached = (target, [low, high]) => Math.min(Math.max(target, 2 * low - high), 2 * high - low);

// The places of the least distances, in order.
function nearest(distances) {
  const count = Math.max(Math.round(CONDITIONING.near * distances.length), CONDITIONING.fewest);
  return d3.sort(d3.sort(d3.range(distances.length), (i) => distances[i]).slice(0, count));
}

function changedBy(name, value, change) {
  const { least, most } = INPUTS[name];
  return Math.min(Math.max(isPositive(name) ? value * Math.exp(change) : value + change, least), most);
}

// The inverse of a matrix of products of columns. Combinations in which members hardly differ are left out.
function inverseOf(products) {
  const { values, vectors } = eigen(products);
  const least = CONDITIONING.least_spread ** 2 * d3.max(values);
  const kept = d3.range(values.length).filter((k) => values[k] > least);
  return products.map((row, i) => row.map((_, j) => d3.sum(kept, (k) => (vectors[k][i] * vectors[k][j]) / values[k])));
}

// Eigenvalues and eigenvectors of a symmetric matrix, by Jacobi's rotations.
function eigen(matrix) {
  const a = matrix.map((row) => [...row]);
  const vectors = a.map((row, i) => row.map((_, j) => Number(i === j)));
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    for (const [q, p] of d3.cross(d3.range(a.length), d3.range(a.length)).filter(([i, j]) => j < i)) {
      const angle = 0.5 * Math.atan2(2 * a[p][q], a[q][q] - a[p][p]);
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const turned = (one, other) => [c * one - s * other, s * one + c * other];
      for (const rows of [a, vectors]) {
        [rows[p], rows[q]] = d3.transpose(rows[p].map((value, i) => turned(value, rows[q][i])));
      }
      for (const row of a) [row[p], row[q]] = turned(row[p], row[q]);
    }
  }
  return { values: a.map((row, i) => row[i]), vectors };
}
