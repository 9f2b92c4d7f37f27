# The workflow with its locked packages, for any folder; docs/workflow.md, "In other projects", says how to use it. The context
# is a copy of the last commit, which knows its version and holds nothing else: git archive HEAD | docker build --tag thirdbody -
FROM python:3.11.7-slim-bookworm
COPY . /thirdbody
RUN cd /thirdbody \
 && python -m pip install --no-cache-dir --require-hashes --requirement locks/workflow.txt \
 && python -m pip install --no-cache-dir --no-deps --no-build-isolation . \
 && mkdir --mode=1777 /work
WORKDIR /work
# Snakemake asks for the home and the name of its user, who has neither with --user
ENV HOME=/tmp USER=nobody
ENTRYPOINT ["snakemake", "--snakefile", "/usr/local/lib/python3.11/site-packages/chenhorng/Snakefile"]
CMD ["--cores", "2"]
