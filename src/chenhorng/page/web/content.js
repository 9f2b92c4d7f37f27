// What the workflow has put into the page: products, statements, and the inputs of the model.

export const content = JSON.parse(document.getElementById("content").textContent);
export const axes = content.axes; // load, then the four conditions of a curve
export const conditionAxes = axes.slice(1);
export const defaultInputs = Object.fromEntries(Object.entries(content.inputs).map(([name, { value }]) => [name, value]));
