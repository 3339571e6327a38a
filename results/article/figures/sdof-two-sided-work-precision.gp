# gnuplot sdof-two-sided-work-precision.gp makes sdof-two-sided-work-precision.svg and sdof-two-sided-work-precision.pdf of sdof-two-sided-work-precision.dat
data = 'sdof-two-sided-work-precision.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'sdof-two-sided-work-precision.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x [-]'
set xrange [4.55e-05:1.92e+00]
set yrange [9.77e-13:2.23e-01]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'exact-orbit' at graph 1.06,0.0420 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 7.415800e-04,2.930860e-12 to graph 1.05,0.0420 nohead lc rgb '#D55E00' lw 0.5 back
set label 'event-driven[flow=cvode]' at graph 1.06,0.1040 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 1.306055e-02,3.058289e-12 to graph 1.05,0.1040 nohead lc rgb '#000000' lw 0.5 back
set label 'event-driven[flow=modal]' at graph 1.06,0.1660 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 3.825730e-04,3.911795e-12 to graph 1.05,0.1660 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm' at graph 1.06,0.6280 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.546346e-03,3.376184e-04 to graph 1.05,0.6280 nohead lc rgb '#D55E00' lw 0.5 back
set label 'aft-hbm' at graph 1.06,0.6900 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 1.537803e-03,3.382368e-04 to graph 1.05,0.6900 nohead lc rgb '#0072B2' lw 0.5 back
set label 'fourier-lipschitz' at graph 1.06,0.7520 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 1.520117e-03,3.382368e-04 to graph 1.05,0.7520 nohead lc rgb '#009E73' lw 0.5 back
set label 'augmented-lagrangian' at graph 1.06,0.8140 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 1.289850e-01,3.382368e-04 to graph 1.05,0.8140 nohead lc rgb '#E69F00' lw 0.5 back
set label 'hat-lcp' at graph 1.06,0.8760 left font ',9' textcolor rgb '#000000' noenhanced
set arrow from 6.843613e-02,9.775305e-04 to graph 1.05,0.8760 nohead lc rgb '#000000' lw 0.5 back
set label 'aft-hbm[plain=true,homotopy=true]' at graph 1.06,0.9380 left font ',9' textcolor rgb '#009E73' noenhanced
set arrow from 6.402948e-01,7.429872e-02 to graph 1.05,0.9380 nohead lc rgb '#009E73' lw 0.5 back
set label 'fourier-lipschitz[plain=true,solver=pivoting]' at graph 1.06,1.0000 left font ',9' textcolor rgb '#E69F00' noenhanced
set arrow from 6.346732e-01,7.429872e-02 to graph 1.05,1.0000 nohead lc rgb '#E69F00' lw 0.5 back
set label '10 error bars' at graph 0.99, first 4.299331e-12 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '5' at 9.367200e-04,4.576414e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 9.414290e-04,2.146072e-02 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '20' at 9.927090e-04,7.622385e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 1.045071e-03,2.697958e-03 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '80' at 1.163490e-03,9.545538e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 1.537803e-03,3.382368e-04 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 6.402948e-01,7.429872e-02 offset 0.4,0.5 font ',7' textcolor rgb '#009E73' noenhanced
set label '10' at 1.630186e-03,2.146072e-02 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '20' at 6.634089e-03,7.622385e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '40' at 5.248723e-03,2.697958e-03 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '80' at 2.063775e-02,9.545538e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '160' at 1.289850e-01,3.382368e-04 offset 0.4,0.5 font ',7' textcolor rgb '#E69F00' noenhanced
set label '1e-4' at 4.034354e-03,3.791636e-05 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-6' at 6.369394e-03,2.112335e-07 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-8' at 1.182855e-02,3.383175e-09 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-10' at 1.306055e-02,3.058289e-12 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '1e-4' at 3.543430e-04,3.638097e-07 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '1e-6' at 3.669410e-04,3.822861e-12 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '64' at 1.365610e-04,3.100765e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '256' at 7.415800e-04,2.930860e-12 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '128' at 2.395840e-04,5.644617e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '512' at 2.049800e-03,1.583138e-02 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '2048' at 1.218987e-02,3.632747e-03 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
set label '8192' at 6.843613e-02,9.775305e-04 offset 0.4,0.5 font ',7' textcolor rgb '#000000' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt 1 lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 5 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#009E73' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#009E73' pt 9 ps 1.1 notitle, \
  data index 4 with lines lc rgb '#E69F00' dt '..-' lw 1.6 notitle, \
  data index 5 with points lc rgb '#E69F00' pt 13 ps 1.1 notitle, \
  data index 6 with lines lc rgb '#000000' dt '-' lw 1.6 notitle, \
  data index 7 with points lc rgb '#000000' pt 5 ps 1.1 notitle, \
  data index 8 with points lc rgb '#000000' pt 4 ps 1.1 notitle, \
  data index 9 with lines lc rgb '#0072B2' dt '.' lw 1.6 notitle, \
  data index 10 with points lc rgb '#0072B2' pt 7 ps 1.1 notitle, \
  data index 11 with points lc rgb '#0072B2' pt 6 ps 1.1 notitle, \
  data index 12 with lines lc rgb '#D55E00' dt '_.' lw 1.6 notitle, \
  data index 13 with points lc rgb '#D55E00' pt 8 ps 1.1 notitle, \
  data index 14 with lines lc rgb '#009E73' dt '..-' lw 1.6 notitle, \
  data index 15 with points lc rgb '#009E73' pt 11 ps 1.1 notitle, \
  data index 16 with lines lc rgb '#E69F00' dt '-' lw 1.6 notitle, \
  data index 17 with points lc rgb '#E69F00' pt 15 ps 1.1 notitle, \
  data index 18 with lines lc rgb '#000000' dt '_.' lw 1.6 notitle, \
  data index 19 with points lc rgb '#000000' pt 7 ps 1.1 notitle, \
  data index 20 with lines lc rgb '#D55E00' dt 1 lw 1.6 notitle, \
  data index 21 with points lc rgb '#D55E00' pt 11 ps 1.1 notitle, \
  4.299331e-12 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
