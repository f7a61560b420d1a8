// How long the GPU takes, where the driver tells.

/** Constants of EXT_disjoint_timer_query_webgl2. */
const TIME_ELAPSED = 0x88bf;
const GPU_DISJOINT = 0x8fbb;

export class GpuClock {
  private readonly offered: boolean;
  private query: WebGLQuery | null = null;
  /** Milliseconds of the last timed work; null where they cannot be had. */
  ms: number | null = null;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.offered = gl.getExtension('EXT_disjoint_timer_query_webgl2') !== null;
  }

  /** Does the work, timing it if no earlier timing is still awaited. */
  time(work: () => void): void {
    this.collect();
    if (!this.offered || this.query) return work();
    this.query = this.gl.createQuery();
    if (!this.query) return work();
    this.gl.beginQuery(TIME_ELAPSED, this.query);
    work();
    this.gl.endQuery(TIME_ELAPSED);
  }

  private collect(): void {
    const { gl, query } = this;
    if (!query || !gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)) return;
    if (!gl.getParameter(GPU_DISJOINT)) this.ms = gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6;
    gl.deleteQuery(query);
    this.query = null;
  }
}
